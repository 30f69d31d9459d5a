/// Colours: what scenes name is sRGB, what is drawn is linear light.
#ifndef BALLOON_VIEW_COLOR_H
#define BALLOON_VIEW_COLOR_H

/// The linear light of an sRGB colour, each 0…1. Source: IEC 61966-2-1.
void color_linear(const float srgb[3], float linear[3]);

/// A scale from dark blue over green to yellow whose brightness rises evenly, so that it keeps its
/// order in grey and for the colour-blind: viridis by S. van der Walt and N. Smith, matplotlib 1.5.
/// t is held within 0…1; the colour is linear.
void color_scale(float t, float linear[3]);

#endif
