// Glossy rubber: a mirror of the studio over a matt and slightly translucent skin.
in vec3 normal;
in float polish;
in vec3 light;
in float solid;
out vec4 color;

void main() {
    vec3 v = -ray_through(gl_FragCoord.xy);
    vec3 n = normalize(normal);
    float facing = dot(n, v);
    n *= sign(facing);
    facing = abs(facing);

    // a sharp reflection, and a broad sheen of the key light
    vec3 r = 2.0 * facing * n - v;
    float near_key = max(dot(r, KEY.toward), 0.0);
    float sheen = near_key * near_key * near_key;
    vec3 gloss = polish * (fresnel(facing) * mirrored(r) + 0.09 * sheen * sheen);

    // slightly translucent toward the outline; highlights are opaque
    float k = 1.0 - facing;
    float hides = solid * (1.0 - 0.30 * k * k * k);
    hides = mix(hides, 1.0, clamp(gloss.g, 0.0, 0.9));
    color = vec4(display(light + gloss) * hides, hides);
}
