out vec4 color;

void main() {
    vec3 wall = backdrop(ray_through(gl_FragCoord.xy));
    color = vec4(dithered(display(wall), gl_FragCoord.xy), 1.0);
}
