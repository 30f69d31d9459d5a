/// The pressure on the skin, and the gas that makes it.
///
///     area       p = 100 amount / area, the mass-spring paper's
///     pressure   p = amount
///     gas        p = unit T/T0 (n V0/V)^g - ambient
///
/// n is the amount of gas in units of what fills V0 at the pressure `unit` and the temperature T0;
/// g = 1 at one temperature, and the heat capacity ratio of the gas when no heat goes through the
/// skin (compressed from the pressure `unit`). The thin-shell paper's p0 V0/V is unit = p0, n = 1,
/// ambient = 0. A gas that the scene names (`filling`) has weight, and its surroundings lift it.
#ifndef BALLOON_BODY_GAS_H
#define BALLOON_BODY_GAS_H

#include <math.h>
#include <stdbool.h>

#include "base/vec.h"

typedef enum InflationLaw {
    INFLATE_NONE, ///< no inflation
    INFLATE_AREA,
    INFLATE_PRESSURE,
    INFLATE_GAS,
    INFLATION_LAWS
} InflationLaw;
extern const char* const inflation_law_name[INFLATION_LAWS];

/// Gases that can fill a balloon: a table.
typedef struct Filling {
    const char* name;
    double density; ///< over that of air at the same pressure and temperature [1]
    double heat;    ///< heat capacity ratio [1]
} Filling;
extern const Filling* const filling_table[];
extern const int filling_count;

extern const double standard_pressure;    ///< 101325 Pa, ISO 2533
extern const double standard_temperature; ///< 293.15 K
extern const double air_density;          ///< 1.2041 kg/m^3 at both

typedef struct Inflation {
    InflationLaw law;
    double amount;      ///< area: k_normal [N]; pressure: [Pa]; gas: n
    double unit;        ///< gas: pressure of n = 1 in V0 at T0 [Pa]
    double ambient;     ///< gas: pressure outside [Pa]
    double temperature; ///< gas: T/T0 [1]
    bool adiabatic;     ///< gas: no heat goes through the skin
    bool weighs;        ///< gas: it has weight, and the air outside lifts it
    const Filling* filling;
    bool paper_tangent;  ///< gas: implicit methods see the thin-shell paper's eq. 16, a third of
                         ///< the stiffness
    double first_volume; ///< V0 [m^3], gas only
    real4* gradient;     ///< [count] dV/dx of the last evaluation [m^2]
    double area;         ///< A of the last evaluation [m^2], area only
    double volume;       ///< V of the last evaluation [m^3], gas only
    double pressure;     ///< p of the last update of the tangent [Pa]
    double slope;        ///< dp/dV of the last update of the tangent [Pa/m^3]
} Inflation;

/// Gauge pressure of a gas in a volume [Pa], and how it changes with the volume [Pa/m^3].
double gas_pressure(const Inflation* gas, double volume);
double gas_slope(const Inflation* gas, double volume);

/// Energy E(V) of gas and surroundings; the gauge pressure is -dE/dV [J].
double gas_energy(const Inflation* gas, double volume);

/// Mass of the gas inside [kg].
double gas_mass(const Inflation* gas);

#endif
