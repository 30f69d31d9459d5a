/// Colors: a scene names them in sRGB; the renderer computes in linear light.
#ifndef BALLOON_VIEW_COLOR_H
#define BALLOON_VIEW_COLOR_H

/// The linear light of an sRGB color, each 0…1. Source: IEC 61966-2-1.
void color_linear(const float srgb[3], float linear[3]);

/// A scale from dark blue over green to yellow whose brightness rises evenly, so that the order
/// stays readable in gray and for the color-blind: viridis by S. van der Walt and N. Smith,
/// matplotlib 1.5. t is clamped to 0…1; the color is linear.
void color_scale(float t, float linear[3]);

#endif
