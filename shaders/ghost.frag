// The skin of a second copy of the scene: faint where it faces the eye, dense toward its outline.
in vec3 normal;
out vec4 color;

void main() {
    float facing = abs(dot(normalize(normal), ray_through(gl_FragCoord.xy)));
    float k = pow(1.0 - facing, 3.0);
    float hides = 0.16 + 0.74 * k;
    vec3 pale = mix(vec3(0.30, 0.85, 1.0), vec3(0.02, 0.25, 0.45), k);
    color = vec4(display(pale) * hides, hides);
}
