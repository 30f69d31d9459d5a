/// Closed forms and other independent solutions, with which runs are compared.
///
/// They share no code with the simulation: only libc's mathematics, in double; every value is
/// computed. Roots are bisected to rounding, motions integrated until halving the step changes
/// nothing, integrals computed by a rule that converges faster than any power.
///
/// Files by noun: truth_law (pressure of a stretched sphere), truth_sphere (at rest and breathing),
/// truth_radial (the moving sphere), truth_particle, truth_sheet (springs as a membrane, strings
/// that hold it), truth_mylar (two sewn discs).
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

/// A law of the skin; in the incompressible ones the thickness l^-2 h0 is substituted.
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

/// First maximum of the pressure above l = 1: false where there is none below l = 10.
/// neo-Hookean: l = 7^(1/6); Hooke's springs: l = 2; Mooney-Rivlin: none above C2/C1 = 0.21445835.
bool truth_peak(const TruthBalloon* balloon, double* l, double* pressure);

/// The balloon of Hooke's springs whose pressure at stretch l is this balloon's.
TruthBalloon truth_springs_fitted(const TruthBalloon* balloon, double l);

// --- the sphere at rest, and its breathing -----------------------------------------------------

/// Stretch with a closed gas of `amount` = n R T/(p_atm V0) >= 1: p_atm (amount/l^3 - 1) = p(l)
/// [1]. Below 1 the skin wrinkles and is no sphere.
double truth_stretch_gas(const TruthBalloon* balloon, double amount);

/// Stretch where p(l) = pressure >= 0, below the first maximum, as a slow inflation reaches it;
/// infinite for a pressure above the maximum [1].
double truth_stretch_pressure(const TruthBalloon* balloon, double pressure);

/// Angular frequency of breathing at stretch l under the constant pressure p(l) [rad/s]:
/// w^2 = W''/(rho R0^2) - 2 l p/(rho h0 R0). l = 1 is the empty skin. NAN beyond the maximum.
double truth_breath_pressure(const TruthBalloon* balloon, double l);

// --- the moving sphere -------------------------------------------------------------------------

/// The state of the moving skin.
typedef struct TruthMotion {
    double l;     ///< stretch [1]
    double speed; ///< dl/dt [1/s]
} TruthMotion;

/// From rest at l = 1, undamped, under a constant `pressure` > 0 from t = 0 on.
TruthMotion truth_sudden(const TruthBalloon* balloon, double pressure, double t);

/// From rest at l = 1, a closed gas that grows as amount = 1 + more min(1, t/duration), damped by
/// a force -damping m v (damping [1/s]).
TruthMotion truth_filling(const TruthBalloon* balloon, double more, double duration, double damping,
                          double t);

// --- particles ---------------------------------------------------------------------------------

/// The cube of 8 particles inflated by the mass-spring paper's `area` law: by symmetry it has one
/// degree of freedom, the distance r of a corner from the center, and its equation is linear. With
/// the side s = 2 r/sqrt(3):
///
///     springs  3 edges at a corner and 3 diagonals, along r: -(2 ks + 4 kd) (r - r0)
///     push     8 f dr = p dV,  p = 100 amount/(6 s^2),  V = s^3:   f = 100 amount sqrt(3)/24
///
/// Each face's two diagonals are the shear springs; a cube has no flexion springs.
typedef struct TruthCube {
    double side;       ///< initial [m]
    double structural; ///< ks [N/m]
    double shear;      ///< kd [N/m]
    double mass;       ///< per particle [kg]
    double drag;       ///< c, force per velocity per particle [N s/m]
    double amount;     ///< of `area` inflation [1]
} TruthCube;

/// The scene exact-cube: side 2, 50/10, 1 g, drag 0.02, amount 1.
TruthCube truth_cube_default(void);

double truth_cube_rest(const TruthCube* cube);             ///< r at rest [m]
double truth_cube_growth(const TruthCube* cube, double t); ///< u(t) = r(t) - r(0), from rest [m]

// --- springs as a sheet, and a tethered balloon ------------------------------------------------

/// A square grid of springs as a membrane, each modulus a force per length.
typedef struct TruthSheet {
    double c11;      ///< ks + 4 kf + kd [N/m]
    double c12;      ///< kd; C66 is the same [N/m]
    double biaxial;  ///< B = C11 + C12 [N/m]
    double along;    ///< E h of a strip along the grid, C11 - C12^2/C11 [N/m]
    double diagonal; ///< E h of a strip at 45 degrees, 4/(2/B + 1/C66) [N/m]
} TruthSheet;

TruthSheet truth_sheet(double structural, double shear, double flexion);

/// Tension of a string that holds `count` particles of mass m at rest under helium's acceleration
/// `lift`: count m (lift - g) [N].
double truth_tether(int count, double mass, double lift, double gravity);

// --- two discs sewn together -------------------------------------------------------------------

/// Two inextensible discs of radius a, sewn at the rim and inflated: the Mylar balloon. Its
/// wrinkles carry no hoop tension, so the meridional tension T satisfies T x = const at distance x
/// from the axis. The balance of the cap within x is T 2 pi x sin = p pi x^2, with sin = 1 at the
/// inflated radius r. So T = p r^2/(2 x) and sin = x^2/r^2:
///
///     z' = -x^2/sqrt(r^4 - x^4),   length of the meridian ds = r^2/sqrt(r^4 - x^4) dx
typedef struct TruthMylar {
    double radius;    ///< inflated, r: a = r * integral of 1/sqrt(1 - t^4), 0 to 1 [m]
    double thickness; ///< pole to pole: 2 r * integral of t^2/sqrt(1 - t^4) [m]
    double volume;    ///< 2 pi r^3 * integral of t^4/sqrt(1 - t^4) [m^3]
} TruthMylar;

TruthMylar truth_mylar(double disc);

#endif
