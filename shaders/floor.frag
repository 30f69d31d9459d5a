uniform sampler2D shadow_map;

in vec3 world;
out vec4 color;

void main() {
    vec2 at = (world.xz - shadow.xy) * shadow.z;
    vec2 cells = vec2(textureSize(shadow_map, 0)) - 1.0;
    vec3 light = texture(shadow_map, (at * cells + 0.5) / (cells + 1.0)).rgb;

    float far = length(world.xz - ground.xy) / ground.z;
    vec3 tone = FLOOR * mix(1.06, 0.97, min(0.3 * far, 1.0)) * (0.06 + 0.94 * light);
    tone = mix(tone, backdrop(ray_through(gl_FragCoord.xy)), smoothstep(1.5, 12.0, far));
    color = vec4(dithered(display(tone), gl_FragCoord.xy), 1.0);
}
