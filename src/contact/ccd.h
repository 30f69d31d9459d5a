/// Continuous collision detection before a drift: no path of a ball's centre crosses a triangle.
#ifndef BALLOON_CONTACT_CCD_H
#define BALLOON_CONTACT_CCD_H

#include "contact/contact.h"

/// Whether the ball's centre crosses the contact's triangle in a drift of length h: a root of the
/// moving pair's path, in double.
bool ccd_passes_through(const Contact* contact, double h);

/// Where the solver left a crossing, give the ball and the triangle's particles their common linear
/// momentum, as in a plastic impact. Repeated over the contacts and the other near triangles until no
/// path crosses; if the iterations run out, the drift is halved. Returns how much of h may be drifted.
double ccd_stop(const Contact* contact, int count, const Contact* near, int near_count, double h);

#endif
