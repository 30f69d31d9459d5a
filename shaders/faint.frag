// A pale shape: translucent where it faces the eye, denser toward its outline.
in vec3 normal;
in float polish;
in vec3 light;
in float solid;
out vec4 color;

void main() {
    float facing = abs(dot(normalize(normal), ray_through(gl_FragCoord.xy)));
    float k = 1.0 - facing;
    vec3 pale = mix(vec3(0.80), light, 0.40);
    float hides = 0.55 + 0.30 * k * k;
    color = vec4(display(pale) * hides, hides);
}
