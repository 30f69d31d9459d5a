/// Closed forms and other independent solutions, with which runs are compared.
///
/// They share no code with the simulation: only libc's mathematics, in double; every value is
/// computed. Roots are bisected to rounding, motions integrated until halving the step changes
/// nothing, integrals computed by a rule that converges faster than any power.
///
/// Files by noun: truth_law (pressure of a stretched sphere), truth_sphere (at rest and breathing),
/// truth_radial (the moving sphere), truth_particle, truth_sheet (springs as a membrane, strings
/// and balls on it), truth_mylar (two sewn discs), truth_limit (the largest stable step).
#ifndef BALLOON_LAB_TRUTH_TRUTH_H
#define BALLOON_LAB_TRUTH_TRUTH_H

#include <stdbool.h>

// --- the spherical balloon ---------------------------------------------------------------------
//
// A thin sphere of radius R = l R0, one degree of freedom l, the stretch. W(l) is the elastic
// energy per volume of unstretched skin. Virtual work, 4 pi R0^2 h0 dW = p 4 pi R^2 dR, gives
//
//     pressure  p(l) = (h0/R0) W'(l) / l^2                                                  [Pa]
//     motion    rho R0^2 l'' = p R0 l^2 / h0 - W'(l) - rho R0^2 c l'                        [Pa]

typedef struct TruthBalloon TruthBalloon;

/// A law of the skin; the incompressible ones have put in the thickness l^-2 h0.
typedef struct TruthLaw {
    const char* name;
    const char* about;
    double (*energy)(const TruthBalloon* balloon, double l);  ///< W, 0 at l = 1 [J/m^3]
    double (*stress)(const TruthBalloon* balloon, double l);  ///< W' [Pa]
    double (*tangent)(const TruthBalloon* balloon, double l); ///< W'' [Pa]
} TruthLaw;

/// neo-hookean, mooney-rivlin, stvk, stvk-3d; hooke and rubber, the two laws of springs.
extern const TruthLaw truth_law_table[];
extern const int truth_law_count;

/// Row by name, or NULL.
const TruthLaw* truth_law_find(const char* name);

struct TruthBalloon {
    const TruthLaw* law;
    double radius;    ///< R0, of the unstretched sphere [m]
    double thickness; ///< h0, of the unstretched skin [m]
    double modulus;   ///< E, Young's modulus; an incompressible skin has mu = E/3 [Pa]
    double density;   ///< rho, of the skin [kg/m^3]
    double ambient;   ///< p_atm, pressure of the air outside [Pa]
    double air;       ///< density of the air outside [kg/m^3]
    double helium;    ///< density of helium over air's at one pressure and temperature [1]
    double poisson;   ///< nu, of the two StVK laws [1]
    double mooney;    ///< C2/C1, of Mooney-Rivlin [1]
    double springs;   ///< B/(E h0), equibiaxial stiffness of the two laws of springs [1]
};

/// The standard balloon: 0.1 m, 0.3 mm, E = 1 MPa, neo-Hookean, in air at sea level.
TruthBalloon truth_balloon_default(void);

/// Gauge pressure at stretch l, p = (h0/R0) W'/l^2 [Pa].
double truth_pressure(const TruthBalloon* balloon, double l);

/// Its slope, dp/dl = (h0/R0) (W'' - 2 W'/l)/l^2 [Pa].
double truth_pressure_slope(const TruthBalloon* balloon, double l);

/// First maximum of the pressure above l = 1: false where there is none below l = 10.
/// neo-Hookean: l = 7^(1/6); Hooke's springs: l = 2; Mooney-Rivlin: none above C2/C1 = 0.21445835.
bool truth_peak(const TruthBalloon* balloon, double* l, double* pressure);

/// The balloon of Hooke's springs whose pressure at stretch l is this balloon's.
TruthBalloon truth_springs_fitted(const TruthBalloon* balloon, double l);

/// Stretch where the stress-free direction of a plane-stress StVK skin has no thickness left:
/// lambda_3^2 = 1 - 2 nu/(1-nu) (l^2-1) = 0, so l = sqrt(1 + (1-nu)/(2 nu)) [1].
double truth_stvk_end(const TruthBalloon* balloon);

// --- the sphere at rest, and its breathing -----------------------------------------------------

/// Stretch of a closed gas of `amount` = n R T/(p_atm V0) >= 1: p_atm (amount/l^3 - 1) = p(l) [1].
/// Below 1 the skin wrinkles and no sphere is the truth.
double truth_stretch_gas(const TruthBalloon* balloon, double amount);

/// Stretch where p(l) = pressure >= 0, before the first maximum: what a slow inflation reaches;
/// infinite above the maximum [1].
double truth_stretch_pressure(const TruthBalloon* balloon, double pressure);

/// Stretch where helium begins to lift the skin, before l = 10; infinite where there is none [1].
/// With V = 4/3 pi (l R0)^3 and helium squeezed to p_atm + p:
/// air V = helium air V (p_atm + p)/p_atm + 4 pi R0^2 h0 rho.
double truth_stretch_flight(const TruthBalloon* balloon);

/// Breathing at stretch l under the pressure p(l) that does not change [rad/s]:
/// w^2 = W''/(rho R0^2) - 2 l p/(rho h0 R0). l = 1 is the empty skin. NAN past the maximum.
double truth_breath_pressure(const TruthBalloon* balloon, double l);

/// Breathing of a closed gas of `amount` about its rest, filled at the air's temperature [rad/s].
/// While it breathes p_atm + p goes as l^(-3 exponent): 1 isothermal, 1.4 adiabatic air, 5/3
/// helium. With P = p_atm amount/l^3: (l^2 p)' = l P (2 - 3 exponent) - 2 l p_atm.
double truth_breath_gas(const TruthBalloon* balloon, double amount, double exponent);

// --- the moving sphere -------------------------------------------------------------------------

/// Where the skin is and how it moves.
typedef struct TruthMotion {
    double l;     ///< stretch [1]
    double speed; ///< dl/dt [1/s]
} TruthMotion;

/// Gauge pressure that is applied at time t and stretch l [Pa].
typedef double (*TruthApplied)(const TruthBalloon* balloon, const void* self, double t, double l);

/// The motion at time `to` of the skin that was at `from` at time `since`, damped by a force
/// -damping m v (damping [1/s]). Runge-Kutta of order 4, steps halved until the end stands still to
/// 1e-12 or to rounding, which a long or nearly run-away motion magnifies; infinite where the skin
/// has run away by then. `applied` is smooth between the two times.
TruthMotion truth_radial(const TruthBalloon* balloon, TruthApplied applied, const void* self,
                         double damping, TruthMotion from, double since, double to);

/// From rest at l = 1, undamped, after a `pressure` > 0 that does not change was let on at t = 0.
TruthMotion truth_sudden(const TruthBalloon* balloon, double pressure, double t);

/// Its furthest stretch: the work of the gas is all elastic, p R0 (l^3-1)/3 = h0 W(l) [1].
/// Infinite at and above the step that runs away.
double truth_sudden_most(const TruthBalloon* balloon, double pressure);

/// Its period, 2 * integral from 1 to the furthest stretch of dl/l' [s].
double truth_sudden_period(const TruthBalloon* balloon, double pressure);

/// The step of pressure above which it runs away, the maximum of 3 h0 W/(R0 (l^3-1)) over l;
/// infinite where there is none below l = 10 [Pa].
double truth_sudden_limit(const TruthBalloon* balloon);

/// From rest at l = 1, a closed gas that grows as amount = 1 + more min(1, t/duration), damped by
/// a force -damping m v (damping [1/s]).
TruthMotion truth_filling(const TruthBalloon* balloon, double more, double duration, double damping,
                          double t);

// --- particles ---------------------------------------------------------------------------------

/// Height after n steps h of free fall from rest, `euler` and backward Euler alike:
/// -g h^2 n(n+1)/2 [m]; g [m/s^2].
double truth_fall(double gravity, double h, int n);

/// Speed after n steps h of `euler` under helium's acceleration `lift`, gravity and drag [m/s]:
/// v_t (1 - (1 - c h/m)^n), v_t = m (lift - g)/c, for any number of particles of mass m.
double truth_rise(double lift, double gravity, double mass, double drag, double h, int n);

/// One damped spring x'' + gamma x' + w2 x = 0 with gamma^2 < 4 w2: x(t) [m].
double truth_spring(double w2, double gamma, double x0, double v0, double t);

/// What `euler` keeps exactly on an undamped spring: v^2/2 + w^2 x^2/2 - h w^2 x v/2 [J/kg].
double truth_euler_invariant(double w2, double h, double x, double v);

/// How fast `euler` swings an undamped spring: (2/h) asin(w h/2) [rad/s].
double truth_euler_frequency(double w, double h);

/// Mode j = 1 … n of n particles in a chain of n + 1 springs between fixed ends:
/// 2 sqrt(k/m) sin(j pi/(2 (n+1))) [rad/s].
double truth_chain(double stiffness, double mass, int n, int j);

/// The cube of 8 particles blown up by the mass-spring paper's `area` law: by symmetry one degree
/// of freedom, the distance r of a corner from the center, and a linear one. With the side
/// s = 2 r/sqrt(3):
///
///     springs  3 edges at a corner and 3 diagonals, along r: -(2 ks + 4 kd) (r - r0)
///     push     8 f dr = p dV,  p = 100 amount/(6 s^2),  V = s^3:   f = 100 amount sqrt(3)/24
///
/// Each face's two diagonals are the shear springs; no flexion spring fits in.
typedef struct TruthCube {
    double side;       ///< at first [m]
    double structural; ///< ks [N/m]
    double shear;      ///< kd [N/m]
    double mass;       ///< per particle [kg]
    double drag;       ///< c, force per velocity per particle [N s/m]
    double amount;     ///< of `area` inflation [1]
} TruthCube;

/// The scene exact-cube: side 2, 50/10, 1 g, drag 0.02, amount 1.
TruthCube truth_cube_default(void);

double truth_cube_w2(const TruthCube* cube);               ///< (2 ks + 4 kd)/m [1/s^2]
double truth_cube_push(const TruthCube* cube);             ///< f, outward on each corner [N]
double truth_cube_rest(const TruthCube* cube);             ///< r at rest [m]
double truth_cube_growth(const TruthCube* cube, double t); ///< u(t) = r(t) - r(0), from rest [m]

// --- springs as a sheet, and what hangs on it --------------------------------------------------

/// A square grid of springs as a membrane, each modulus a force per length.
typedef struct TruthSheet {
    double c11;      ///< ks + 4 kf + kd [N/m]
    double c12;      ///< kd; C66 is the same [N/m]
    double biaxial;  ///< B = C11 + C12 [N/m]
    double along;    ///< E h of a strip along the grid, C11 - C12^2/C11 [N/m]
    double diagonal; ///< E h of a strip at 45 degrees, 4/(2/B + 1/C66) [N/m]
} TruthSheet;

TruthSheet truth_sheet(double structural, double shear, double flexion);

/// l - 1 of a sphere of Hooke's springs under `area` inflation, pressure 100 amount/A:
/// 100 amount/(4 pi R0^2 l^2) = 2 B (l-1)/(R0 l^2), so 100 amount/(8 pi R0 B), exactly [1].
double truth_area_growth(double amount, double radius, double biaxial);

/// Tension of the string that holds `count` particles of mass m at rest under helium's acceleration
/// `lift`: count m (lift - g) [N].
double truth_tether(int count, double mass, double lift, double gravity);

/// Upward force on a ball at rest in a membrane, contact circle of radius rc, ball of radius a,
/// meridional tension T at the edge: pi rc^2 (p + 2 T/a) [N]. The tension pulls along the ball's
/// tangent, T 2 pi rc sin(angle) with sin(angle) = rc/a. A flat plate has a infinite.
double truth_ball(double contact, double pressure, double tension, double ball);

// --- two discs sewn together -------------------------------------------------------------------

/// Two inextensible discs of radius a sewn at the rim and blown up, the Mylar balloon: wrinkles let
/// the hoops go slack, all tension runs along the meridians. Slack hoops keep T x the same all
/// along; the cap inside x is held by T 2 pi x sin = p pi x^2, and the rim, at the inflated radius
/// r, has sin = 1. So T = p r^2/(2 x) and sin = x^2/r^2:
///
///     z' = -x^2/sqrt(r^4 - x^4),   length of the meridian ds = r^2/sqrt(r^4 - x^4) dx
typedef struct TruthMylar {
    double radius;    ///< inflated, r: a = r * integral of 1/sqrt(1 - t^4), 0 to 1 [m]
    double thickness; ///< pole to pole: 2 r * integral of t^2/sqrt(1 - t^4) [m]
    double volume;    ///< 2 pi r^3 * integral of t^4/sqrt(1 - t^4) [m^3]
} TruthMylar;

TruthMylar truth_mylar(double disc);

/// Its meridional tension at distance x from the axis, p r^2/(2 x) [N/m].
double truth_mylar_tension(const TruthMylar* mylar, double pressure, double x);

// --- the largest stable step -------------------------------------------------------------------
//
// w2, the largest eigenvalue of M^-1 K [1/s^2]; gamma = c/m [1/s]. Stable where no eigenvalue of
// the step's matrix on (x, v) lies outside the unit circle, for every mode from w = 0 to sqrt(w2).

/// Semi-implicit Euler, v' = v + h f, x' = x + h v': trace 2 - gamma h - w2 h^2, determinant
/// 1 - gamma h; -1 becomes an eigenvalue at h = (-gamma + sqrt(gamma^2 + 4 w2))/w2, which is
/// 4/(gamma + sqrt(gamma^2 + 4 w2)) [s].
double truth_limit_euler(double w2, double gamma);

/// Forward Euler, 1 + h z with z^2 + gamma z + w2 = 0: gamma/w2 where z is complex, else
/// 4/(gamma + sqrt(gamma^2 - 4 w2)); at most 2/gamma, where rigid motion ends. 0 undamped [s].
double truth_limit_forward(double w2, double gamma);

#endif
