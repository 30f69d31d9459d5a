// A square that covers the ball's outline as seen from the eye.
layout(location = 0) in vec3 ball_center;
layout(location = 1) in float ball_radius;
layout(location = 2) in vec3 ball_color;

flat out vec3 center;
flat out float radius;
flat out vec3 tint;
out vec3 world;

void main() {
    center = ball_center;
    radius = ball_radius;
    tint = ball_color;

    // the tangent cone from the eye touches the ball on a circle in front of its center; 1.5 pixels
    // are added for the antialiased edge
    vec3 to = center - eye.xyz;
    float away = max(length(to), 1.001 * radius);
    vec3 w = to / away;
    vec3 u = normalize(cross(w, up.xyz)), v = cross(u, w);
    float sight = sqrt(away * away - radius * radius);
    float half_side = radius * away / sight + 1.5 * size.z * away;

    vec2 corner = vec2(gl_VertexID % 2, gl_VertexID / 2) * 2.0 - 1.0;
    world = center + half_side * (corner.x * u + corner.y * v);
    gl_Position = view_projection * vec4(world, 1.0);
}
