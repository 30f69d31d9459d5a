// A thin round wire: brightest along its center line.
in vec3 tint;
in float across;
out vec4 color;

void main() {
    float round = sqrt(max(1.0 - across * across, 0.0));
    color = vec4(display(tint * (0.55 + 0.45 * round)), 1.0);
}
