// The glow, blended over the picture outside the shape.
uniform sampler2D blurred;

in vec2 at;
out vec4 color;

const vec3 GLOW = vec3(1.0, 0.72, 0.20);

void main() {
    vec2 blur = texture(blurred, at * 0.5 + 0.5).rg;
    float glow = min(2.2 * blur.r, 1.0) * (1.0 - smoothstep(0.35, 0.85, blur.g));
    color = vec4(GLOW * glow, glow) * 0.9;
}
