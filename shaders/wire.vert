// A line as a quad of constant width in pixels.
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec3 color;
layout(location = 3) in float width;

out vec3 tint;
out float across; // -1 … 1

// Offset of all lines toward the eye, for those that lie on a skin. [of the distance]
const float LIFT = 0.004;

vec4 clip(vec3 p) {
    return view_projection * vec4(mix(p, eye.xyz, LIFT), 1.0);
}

void main() {
    vec4 a = clip(from), b = clip(to);

    // an end behind the eye is clipped to a point in front of it
    float near = 1e-3 * ground.z;
    if (a.w < near && b.w > near)
        a = mix(b, a, (b.w - near) / (b.w - a.w));
    if (b.w < near && a.w > near)
        b = mix(a, b, (a.w - near) / (a.w - b.w));

    vec2 pixels = size.xy * 0.5;
    vec2 along = (b.xy / b.w - a.xy / a.w) * pixels;
    float len = length(along);
    along = len > 1e-6 ? along / len : vec2(1.0, 0.0);

    across = float(gl_VertexID % 2) * 2.0 - 1.0;
    float half_width = max(0.5 * width * size.w, 0.5);
    vec4 p = gl_VertexID < 2 ? a : b;
    p.xy += vec2(-along.y, along.x) * across * half_width / pixels * p.w;
    gl_Position = p;
    tint = color;
}
