// Diffuse light on a skin varies slowly enough to be computed at its vertices; the fragment shaders
// add reflections.
layout(location = 0) in vec3 point;
layout(location = 1) in vec3 point_normal;
layout(location = 2) in vec3 point_color;
layout(location = 3) in float point_stretch;
layout(location = 4) in float point_open;

out vec3 normal;
out float polish; // 1 outside, less on the inside of a closed skin
out vec3 light;   // diffuse
out float solid;  // opacity

void main() {
    gl_Position = view_projection * vec4(point, 1.0);
    normal = point_normal;
    float facing = dot(point_normal, normalize(eye.xyz - point));

    // rubber keeps its volume: a skin stretched by s in both directions is thinner by s^2, and paler
    float thin = 1.0 / max(point_stretch * point_stretch, 1.0);
    float dye = pow(thin, 0.45);
    vec3 albedo = pow(point_color, vec3(mix(0.45, 1.25, dye)));

    // light from the side of the normal, and transmitted light from the other side; the eye may see
    // either side of an open skin
    float turned = point_open * smoothstep(0.1, -0.1, facing);
    vec3 above = arriving(point_normal), below = arriving(-point_normal);
    light = albedo * mix(above, below, turned) * 0.78 +
            albedo * mix(albedo, vec3(1.0), 0.2) * mix(below, above, turned) * 0.75;

    // darker close to the floor, which there lies in the skin's own shadow
    float height = max(point.y - ground.w, 0.0) / (0.10 * ground.z);
    light *= mix(1.0, smoothstep(-1.0, 1.0, height), 0.5 - 0.5 * point_normal.y);

    // only transmitted light reaches the inside of a closed skin
    float inside = (1.0 - point_open) * smoothstep(0.0, -0.6, facing);
    light *= mix(vec3(1.0), albedo * 0.85 + 0.05, inside);
    polish = mix(1.0, 0.4, inside);
    solid = (1.0 - exp(-3.3 * pow(thin, 0.55))) * mix(1.0, 0.9, inside);
}
