// An opaque glossy ball: intersects the ray from the eye with the ball; alpha is the fraction of
// the pixel that the ball covers.
flat in vec3 center;
flat in float radius;
flat in vec3 tint;
in vec3 world;
out vec4 color;

void main() {
    vec3 ray = normalize(world - eye.xyz);
    vec3 to = center - eye.xyz;
    float along = dot(to, ray);
    float miss = length(to - along * ray); // distance of the ray from the center
    float covered = clamp((radius - miss) / (size.z * along) + 0.5, 0.0, 1.0);
    if (covered == 0.0)
        discard;

    float inside = sqrt(max(radius * radius - miss * miss, 0.0));
    vec3 hit = eye.xyz + (along - inside) * ray;
    vec4 clip = view_projection * vec4(hit, 1.0);
    gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;

    vec3 n = normalize(hit - center);
    float facing = clamp(dot(n, -ray), 0.0, 1.0);
    vec3 light = tint * arriving(n) + fresnel(facing) * mirrored(reflect(ray, n));
    color = vec4(display(light), covered);
}
