// A Gaussian blur along one axis: wide in red, for the glow; narrow in green, for the shape's mask.
uniform sampler2D shape;
uniform vec2 direction; // one pixel along the axis

in vec2 at;
out vec4 color;

void main() {
    vec2 uv = at * 0.5 + 0.5;
    vec2 sum = vec2(0.0), weights = vec2(0.0);
    for (int i = -5; i <= 5; i++) {
        vec2 weight = exp(vec2(-0.10, -0.5) * float(i * i));
        sum += weight * texture(shape, uv + float(i) * direction).rg;
        weights += weight;
    }
    color = vec4(sum / weights, 0.0, 1.0);
}
