// What every shader knows of the picture. Twin of FrameBlock in src/draw/frame.h.
layout(std140) uniform Frame {
    mat4 view_projection; // world to clip space
    vec4 eye;             // x y z
    vec4 corner;          // from the eye to the picture's lower left, one unit before the eye
    vec4 right;           // from one pixel there to the next
    vec4 up;              // … to the one above
    vec4 size;            // width, height [px], height of a pixel at distance 1, px per 720th
    vec4 ground;          // middle x z of the scene, its radius, floor height
    vec4 shadow;          // lower corner x z of the shadow map, 1 / its width
};

// The unit vector from the eye through a pixel, counted from the lower left.
vec3 ray_through(vec2 pixel) {
    return normalize(corner.xyz + pixel.x * right.xyz + pixel.y * up.xyz);
}
