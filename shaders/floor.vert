// A square of floor, so wide that its edge has faded into the backdrop. An eye below the floor would
// not see the scene, so the square is then moved out of the clip volume.
out vec3 world;

const float REACH = 16.0; // scene radii

void main() {
    vec2 corner = vec2(gl_VertexID % 2, gl_VertexID / 2) * 2.0 - 1.0;
    vec2 p = ground.xy + corner * REACH * ground.z;
    world = vec3(p.x, ground.w, p.y);
    gl_Position = eye.y > ground.w ? view_projection * vec4(world, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
