/// The contact of a ball with the nearest point of a triangle.
#ifndef BALLOON_CONTACT_BALL_TRIANGLE_H
#define BALLOON_CONTACT_BALL_TRIANGLE_H

#include "body/body.h"
#include "contact/contact.h"
#include "contact/sphere.h"

/// Node 0 is the ball's centre c, nodes 1 to 3 are the corners of the triangle with minus the
/// barycentric weights of its point p nearest c; n points from p to c and the gap is
/// |c - p| - radius. Where c lies in the triangle's plane, n is the triangle's normal times `side`. The
/// effective masses are left to contact_set_masses: most near triangles touch nothing.
void ball_triangle_contact(Contact* contact, Sphere* sphere, Body* body, int triangle, real side);

#endif
