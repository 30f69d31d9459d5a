// The studio that lights all surfaces: two soft boxes and a back light, a sky that darkens upward,
// and a pale floor that reflects light. Light is linear; 1 is a white wall.

struct SoftBox {
    vec3 toward; // unit vector to its center
    vec3 right, up;
    vec2 half_size; // at distance 1
    float soft;     // width of its soft edge
    vec3 light;
};

// The x and z of the key's direction over its y are KEY_X, KEY_Z of src/draw/shadow.c.
const SoftBox KEY = SoftBox(vec3(-0.3801, 0.8447, 0.3801), vec3(0.7071, 0.0, 0.7071),
                            vec3(0.5973, 0.5352, -0.5973), vec2(0.34, 0.42), 0.10,
                            vec3(15.0, 14.7, 14.0));
const SoftBox FILL = SoftBox(vec3(0.8165, 0.4082, 0.4082), vec3(0.4472, 0.0, -0.8944),
                             vec3(-0.3651, 0.9129, -0.1826), vec2(0.12, 0.55), 0.10,
                             vec3(2.6, 2.9, 3.2));
const SoftBox BACK = SoftBox(vec3(0.2357, 0.4714, -0.8498), vec3(-0.9636, 0.0, -0.2673),
                             vec3(-0.1260, 0.8819, 0.4543), vec2(0.45, 0.25), 0.15,
                             vec3(2.6, 2.6, 2.7));

const vec3 FLOOR = vec3(0.90, 0.885, 0.865);

// The color of the wall behind the scene in direction d.
vec3 backdrop(vec3 d) {
    vec3 low = vec3(0.86, 0.86, 0.855), high = vec3(0.24, 0.47, 0.78);
    return mix(low, high, smoothstep(-0.06, 0.42, d.y));
}

// The intensity 0…1 of a soft box in direction d, with soft edges.
float box(SoftBox b, vec3 d) {
    float along = max(dot(d, b.toward), 1e-3);
    vec2 p = abs(vec2(dot(d, b.right), dot(d, b.up)) / along) - b.half_size;
    vec2 inside = vec2(1.0) - smoothstep(-b.soft, b.soft, p);
    return step(0.01, along) * inside.x * inside.y;
}

// The light that a mirror reflects from direction d.
vec3 mirrored(vec3 d) {
    vec3 round = mix(FLOOR * 0.42, vec3(0.55, 0.63, 0.74), smoothstep(-0.7, 0.6, d.y));
    return round + box(KEY, d) * KEY.light + box(FILL, d) * FILL.light + box(BACK, d) * BACK.light;
}

// Irradiance of a matt surface with normal n: the sky above, the floor below, and the boxes; a wide
// box still lights a surface that faces slightly away from its center.
vec3 arriving(vec3 n) {
    vec3 even = mix(FLOOR * 0.50, vec3(0.52, 0.56, 0.62), 0.5 + 0.5 * n.y);
    float key = max(dot(n, KEY.toward) + 0.35, 0.0) / 1.35;
    float fill = max(dot(n, FILL.toward) + 0.3, 0.0) / 1.3;
    float back = max(dot(n, BACK.toward) + 0.3, 0.0) / 1.3;
    return even * 0.75 + key * key * vec3(1.25, 1.21, 1.12) + fill * vec3(0.12, 0.14, 0.17) +
           back * vec3(0.20, 0.21, 0.22);
}

// Schlick's Fresnel term for rubber, reduced at grazing angles because real rubber is rough.
float fresnel(float facing) {
    float k = 1.0 - facing;
    float k2 = k * k;
    return 0.04 + 0.50 * k2 * k2 * k;
}

// Converts linear light to display values: a tone curve that keeps highlights from clipping,
// x (1 + 0.14 x) / (1 + 0.36 x), then the sRGB curve. One rational function approximates both to
// 0.006: the powers of sRGB would take a third of the frame's time in software.
vec3 display(vec3 light) {
    vec3 shown = light * (13.232 + 72.408 * light) / (1.0 + light * (44.668 + 46.687 * light));
    return min(shown, 1.0);
}

// Adds noise of up to half a step of eight bits, so that smooth gradients show no bands.
// Source: J. Jimenez, Next Generation Post Processing in Call of Duty, SIGGRAPH 2014.
vec3 dithered(vec3 color, vec2 pixel) {
    float noise = fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
    return color + (noise - 0.5) / 255.0;
}
