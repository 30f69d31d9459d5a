// A matt surface in the colors of a field, without reflections.
in vec3 normal;
in float polish;
in vec3 light;
in float solid;
out vec4 color;

void main() {
    color = vec4(display(light), 1.0);
}
