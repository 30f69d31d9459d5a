// A matt surface in the colours of a field: only enough shading for its shape to be read.
in vec3 normal;
in float polish;
in vec3 light;
in float solid;
out vec4 color;

void main() {
    color = vec4(display(light), 1.0);
}
