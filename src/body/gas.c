#include "body/gas.h"

#include <stddef.h>

const char* const inflation_law_name[INFLATION_LAWS] = {"none", "area", "pressure", "gas"};

const double standard_pressure = 101325;
const double standard_temperature = 293.15;
const double air_density = 1.2041;

static const Filling air = {.name = "air", .density = 1, .heat = 1.4};
static const Filling helium = {.name = "helium", .density = 0.138, .heat = 5.0 / 3};

const Filling* const filling_table[] = {&air, &helium};
const int filling_count = sizeof filling_table / sizeof *filling_table;

/// a^e for a > 0 and 1 < e < 2, by the binary digits of e and square roots, so that every machine
/// gives the same bits: a * a^(1/2)^d1 * a^(1/4)^d2 …
static double power(double a, double e) {
    double result = a, root = a;
    double rest = e - 1;
    for (int digit = 0; digit < 52; digit++) {
        root = sqrt(root);
        rest *= 2;
        if (rest >= 1) {
            result *= root;
            rest -= 1;
        }
    }
    return result;
}

/// Absolute pressure. [Pa]
static double absolute(const Inflation* gas, double volume) {
    const double filled = gas->amount * gas->first_volume / volume;
    return gas->unit * gas->temperature *
           (gas->adiabatic ? power(filled, gas->filling->heat) : filled);
}

static double exponent(const Inflation* gas) {
    return gas->adiabatic ? gas->filling->heat : 1;
}

double gas_pressure(const Inflation* gas, double volume) {
    return absolute(gas, volume) - gas->ambient;
}

double gas_slope(const Inflation* gas, double volume) {
    return -exponent(gas) * absolute(gas, volume) / volume;
}

double gas_energy(const Inflation* gas, double volume) {
    const double inside = gas->adiabatic ? absolute(gas, volume) * volume / (gas->filling->heat - 1)
                                         : -gas->unit * gas->temperature * gas->amount *
                                               gas->first_volume * log(volume);
    return inside + gas->ambient * volume;
}

double gas_mass(const Inflation* gas) {
    return gas->filling->density * air_density * gas->unit / standard_pressure * gas->amount *
           gas->first_volume;
}
