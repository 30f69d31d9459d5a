/// The last word before a drift: no path of a ball's centre goes through a triangle.
#ifndef BALLOON_CONTACT_CCD_H
#define BALLOON_CONTACT_CCD_H

#include "contact/contact.h"

/// Does the ball's centre go through the contact's triangle in a drift of length h? Swept, in
/// double.
bool ccd_passes_through(const Contact* contact, double h);

/// What the impulses could not solve stops: a ball and a triangle that it would go through go on
/// together, with their common linear momentum. Spherical by round over the near triangles; where
/// rounds run out, the drift ends sooner. Returns how much of h may be drifted.
double ccd_stop(const Contact* near, int count, double h);

#endif
