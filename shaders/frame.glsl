// Data that all shaders share; the same block as FrameBlock in src/draw/frame.h. The image plane is
// the picture as a rectangle at distance 1 in front of the eye.
layout(std140) uniform Frame {
    mat4 view_projection; // world to clip space
    vec4 eye;             // x y z
    vec4 corner;          // vector from the eye to the image plane's lower left corner
    vec4 right;           // vector from a pixel of the image plane to its right neighbor
    vec4 up;              // vector to the pixel above
    vec4 size;            // width, height [px], height of a pixel at distance 1, height / 720
    vec4 ground;          // center x z of the scene, its radius, floor height
    vec4 shadow;          // corner of least x and z of the shadow map, 1 / its width
};

// The unit vector from the eye through a pixel; pixels count from the lower left.
vec3 ray_through(vec2 pixel) {
    return normalize(corner.xyz + pixel.x * right.xyz + pixel.y * up.xyz);
}
