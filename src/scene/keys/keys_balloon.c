/// The keys of a balloon.
#include "scene/key.h"

#include <math.h>

#include "force/material.h"

#define AT(field) .offset = offsetof(DEF, field)
#define COUNT(field) .count_offset = offsetof(DEF, field)
#define GROUP(rows, Def)                                                                           \
    { .key = rows, .count = sizeof rows / sizeof rows[0], .size = sizeof(Def) }

// clang-format off
#define DEF SpringsDef
static const Key springs_row[] = {
    {{"structural", "N/m", NOT_NEGATIVE, 0, "stiffness along edges; 0: no such springs"}, KEY_NUMBER,
     AT(structural)},
    {{"shear", "N/m", NOT_NEGATIVE, 0, "stiffness across faces"}, KEY_NUMBER, AT(shear)},
    {{"flexion", "N/m", NOT_NEGATIVE, 0, "stiffness over a particle to the next but one"}, KEY_NUMBER,
     AT(flexion)},
    {{"torsion", "N m", NOT_NEGATIVE, 0, "stiffness against bending at edges: the one kind that "
      "acts on an angle"}, KEY_NUMBER, AT(torsion)},
    {{"law", NO_NUMBER, "force of a spring over its stretch"}, KEY_NAME, AT(law),
     .name = spring_law_name, .name_count = SPRING_LAWS},
};
#undef DEF
static const KeyGroup springs_keys = GROUP(springs_row, SpringsDef);

#define DEF PatchDef
static const Key patch_row[] = {
    {{"at", "m", ANY, NAN, "middle of the patch, in the world at the start"}, KEY_VECTOR, AT(at), .required = true},
    {{"radius", "m", POSITIVE, NAN, "distance from the middle at which the patch ends"}, KEY_NUMBER, AT(radius),
     .required = true},
    {{"thickness", "m", POSITIVE, NAN, "thickness in the middle of the patch; it goes over into the skin's smoothly"}, KEY_NUMBER,
     AT(thickness), .required = true},
};
#undef DEF
static const KeyGroup patch_keys = GROUP(patch_row, PatchDef);

#define DEF MembraneDef
static const Key membrane_row[] = {
    {{"material", NO_NUMBER, "law of the rubber"}, KEY_TEXT, AT(material), .required = true,
     .longest = WORD_LONGEST, .table = material_table, .table_count = &material_count},
    {{"young", "Pa", POSITIVE, NAN, "Young's modulus E"}, KEY_NUMBER, AT(young), .required = true},
    {{"density", "kg/m^3", POSITIVE, NAN, "density of the rubber"}, KEY_NUMBER, AT(density),
     .required = true},
    {{"thickness", "m", POSITIVE, NAN, "thickness of the rubber without stress"}, KEY_NUMBER, AT(thickness),
     .required = true},
    {{"volume", NO_NUMBER, "how the rubber keeps its volume: each element by its thickness, or all "
      "by moving the skin"}, KEY_NAME, AT(volume), .name = volume_rule_name,
     .name_count = VOLUME_RULES},
    {{"patches", NO_NUMBER, "parts with a thickness of their own"}, KEY_LIST, AT(patches),
     COUNT(patches_count), .group = &patch_keys},
};
#undef DEF
static const KeyGroup membrane_keys = {.key = membrane_row,
                                       .count = sizeof membrane_row / sizeof *membrane_row,
                                       .more = key_of_material,
                                       .selector = "material",
                                       .size = sizeof(MembraneDef)};

#define DEF SkinDef
static const Key skin_row[] = {
    {{"springs", NO_NUMBER, "a skin of springs"}, KEY_POINTER, AT(springs), .group = &springs_keys},
    {{"membrane", NO_NUMBER, "a skin of rubber with thickness; not with `springs`"}, KEY_POINTER,
     AT(membrane), .group = &membrane_keys},
};
#undef DEF
static const KeyGroup skin_keys = GROUP(skin_row, SkinDef);

#define DEF MassDef
static const Key mass_row[] = {
    {{"per_particle", "kg", 0, INFINITY, true, false, true, NAN, "mass of each particle"}, KEY_NUMBER, AT(per_particle),
     .required = true},
};
#undef DEF
static const KeyGroup mass_keys = GROUP(mass_row, MassDef);

#define DEF FillDef
static const Key fill_row[] = {
    {{"to", "of amount", ANY, NAN, "amount at the end"}, KEY_NUMBER, AT(to), .required = true},
    {{"start", "s", NOT_NEGATIVE, 0, "when filling begins"}, KEY_NUMBER, AT(start)},
    {{"seconds", "s", POSITIVE, NAN, "how long it lasts"}, KEY_NUMBER, AT(seconds),
     .required = true},
};
#undef DEF
static const KeyGroup fill_keys = GROUP(fill_row, FillDef);

#define DEF InflationDef
static const Key inflation_row[] = {
    {{"law", NO_NUMBER, "what the pressure depends on"}, KEY_NAME, AT(law), .required = true,
     .name = inflation_law_name, .name_count = INFLATION_LAWS},
    {{"amount", "of amount", ANY, 0, "area [N]: the pressure is 100 amount over the skin's area; "
      "pressure [Pa]: gauge pressure; gas [1]: multiples of the gas that fills the first volume at "
      "the pressure `unit`"}, KEY_NUMBER,
     AT(amount)},
    {{"rate", "of amount/s", NOT_NEGATIVE, NAN, "change while the key is held"}, KEY_NUMBER, AT(rate),
     .absent = "a tenth of the range from `min` to `max`"},
    {{"min", "of amount", ANY, 0, "smallest amount that the keys reach"}, KEY_NUMBER, AT(min),
     .old = "least"},
    {{"max", "of amount", ANY, NAN, "largest amount that the keys reach"}, KEY_NUMBER, AT(max),
     .old = "most",
     .absent = "ten times the amount, or 100 where that is not above 0"},
    {{"ambient", "Pa", NOT_NEGATIVE, 101325, "gas: pressure outside"}, KEY_OPTIONAL, AT(ambient)},
    {{"unit", "Pa", POSITIVE, NAN, "gas: pressure of amount 1 in the first volume"}, KEY_OPTIONAL,
     AT(unit), .absent = "`ambient`, or 101325 where that is 0"},
    {{"temperature", "K", POSITIVE, 293.15, "gas: its temperature; amount 1 has the pressure `unit` at 293.15 K"},
     KEY_OPTIONAL, AT(temperature)},
    {{"adiabatic", NO_NUMBER, "gas: no heat goes through the skin"}, KEY_FLAG, AT(adiabatic)},
    {{"filling", NO_NUMBER, "gas: which one; it has weight, and the air outside lifts the balloon"},
     KEY_TEXT, AT(filling), .absent = "a gas without weight", .longest = WORD_LONGEST,
     .table = filling_table, .table_count = &filling_count},
    {{"leak", "1/(s Pa)", NOT_NEGATIVE, 0, "gas: amount lost per second and pascal of gauge pressure"},
     KEY_NUMBER, AT(leak)},
    {{"vent", "1/(s Pa)", NOT_NEGATIVE, NAN, "gas: the same while the deflate key is held"}, KEY_NUMBER, AT(vent), .absent = "`rate` per 1000 Pa"},
    {{"fill", NO_NUMBER, "the amount changes in a straight line over time"}, KEY_POINTER, AT(fill),
     .group = &fill_keys},
};
#undef DEF
static const KeyGroup inflation_keys = GROUP(inflation_row, InflationDef);

#define DEF StrainLimitDef
static const Key strain_limit_row[] = {
    {{"structural", "1", NOT_NEGATIVE, 0, "largest strain of structural springs; 0: not limited"},
     KEY_NUMBER, AT(structural)},
    {{"shear", "1", NOT_NEGATIVE, 0, "the same of shear springs"}, KEY_NUMBER, AT(shear)},
    {{"flexion", "1", NOT_NEGATIVE, 0, "the same of flexion springs"}, KEY_NUMBER, AT(flexion)},
    {{"tarantino", NO_NUMBER, "a spring that was limited exerts no force in the next step"}, KEY_FLAG,
     AT(tarantino)},
    {{"phantom", NO_NUMBER, "positions move and velocities do not"}, KEY_FLAG, AT(phantom)},
};
#undef DEF
static const KeyGroup strain_limit_keys = GROUP(strain_limit_row, StrainLimitDef);

#define DEF StringDef
static const Key string_row[] = {
    {{"to", "m", ANY, NAN, "the fixed end"}, KEY_VECTOR, AT(to), .absent = "straight down on the floor"},
    {{"at", NO_NUMBER, "the particle: `nearest` to the other end, `lowest`, `highest`, or its number"},
     KEY_TEXT, AT(at), .absent = "`nearest`, or `lowest` without another end", .longest = WORD_LONGEST},
    {{"to_balloon", "1", NOT_NEGATIVE, NAN, "number of another balloon that the string leads to, from 0"},
     KEY_OPTIONAL, AT(to_balloon), .absent = "none"},
    {{"to_knot", "1", NOT_NEGATIVE, NAN, "number of a knot that the string leads to, from 0"},
     KEY_OPTIONAL, AT(to_knot), .absent = "none"},
    {{"to_thing", "1", NOT_NEGATIVE, NAN, "number of a thing that the string leads to, from 0"},
     KEY_OPTIONAL, AT(to_thing), .absent = "none"},
    {{"to_at", NO_NUMBER, "the particle of that balloon or the point of that thing, as in `at`"}, KEY_TEXT, AT(to_at),
     .absent = "`nearest`", .longest = WORD_LONGEST},
    {{"stiffness", "N/m", NOT_NEGATIVE, NAN, "stiffness of the taut string"}, KEY_NUMBER, AT(stiffness),
     .required = true},
    {{"slack", "1", POSITIVE, 1, "free length as a ratio of the first length"}, KEY_NUMBER,
     AT(slack)},
};
#undef DEF
static const KeyGroup string_keys = GROUP(string_row, StringDef);

#define DEF PinDef
static const Key pin_row[] = {
    {{"at", "m", ANY, NAN, "a point of the world at the start"}, KEY_VECTOR, AT(at), .required = true},
    {{"radius", "m", POSITIVE, NAN, "the particles up to here from it are held"}, KEY_NUMBER, AT(radius),
     .required = true},
    {{"to_thing", "1", NOT_NEGATIVE, NAN, "number of the thing that holds them, from 0"}, KEY_OPTIONAL,
     AT(to_thing), .absent = "none: they do not move"},
};
#undef DEF
static const KeyGroup pin_keys = GROUP(pin_row, PinDef);

#define DEF BalloonDef
static const Key balloon_row[] = {
    {{"model", NO_NUMBER, "a shape, or a mesh beside the scene or in assets/models"}, KEY_TEXT,
     AT(model), .required = true, .longest = TEXT_LONGEST},
    {{"position", "m", ANY, NAN, "added to the model's points"}, KEY_VECTOR, AT(position),
     .absent = "the origin"},
    {{"size", "m", POSITIVE, NAN, "the model is centered on the origin and its longest side scaled to "
      "this"}, KEY_NUMBER, AT(size), .absent = "the model's own"},
    {{"scale", "1", POSITIVE, 1, "factor on the model's points"}, KEY_NUMBER, AT(scale)},
    {{"rotation", "degrees", ANY, 0, "rotation about y, before the position is added"}, KEY_NUMBER,
     AT(rotation), .old = "turn"},
    {{"color", "1", 0, 1, false, false, false, NAN, "red, green and blue in sRGB"}, KEY_VECTOR, AT(color),
     .absent = "the palette's next"},
    {{"skin", NO_NUMBER, "what holds the particles together"}, KEY_MAPPING, AT(skin),
     .group = &skin_keys},
    {{"mass", NO_NUMBER, "mass of the particles; required unless the skin is a membrane, which "
     "has its rubber's"}, KEY_POINTER, AT(mass),
     .group = &mass_keys},
    {{"hold_rim", NO_NUMBER, "the rim of an open mesh does not move"}, KEY_FLAG, AT(hold_rim)},
    {{"inflation", NO_NUMBER, "the pressure inside"}, KEY_POINTER, AT(inflation),
     .group = &inflation_keys},
    {{"strain_limit", NO_NUMBER, "strain limiting of over-stretched springs"},
     KEY_POINTER, AT(strain_limit), .old = "correction", .group = &strain_limit_keys},
    {{"strings", NO_NUMBER, "strings to fixed points, to other balloons, to knots and to things"}, KEY_LIST, AT(strings),
     COUNT(strings_count), .group = &string_keys},
    {{"pins", NO_NUMBER, "particles that are held, or that things hold"}, KEY_LIST, AT(pins), COUNT(pins_count),
     .group = &pin_keys},
};
#undef DEF
// clang-format on

const KeyGroup balloon_keys = {.key = balloon_row,
                               .count = sizeof balloon_row / sizeof *balloon_row,
                               .more = key_of_force,
                               .size = sizeof(BalloonDef)};
