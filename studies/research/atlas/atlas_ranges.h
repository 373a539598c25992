/* atlas_ranges.h - the ranges from which the rooms of the sweep are drawn. Inside
 * studies/research/atlas/ only.
 *
 * One half of the rooms are ordinary rooms of offices, schools and homes. The other
 * half extends to the limits within which hand methods are used. Values are uniform in
 * their range, or in its logarithm if stated. The elements of `roofs`, `places`,
 * `styles`, `panes` and `surroundings` are probabilities and add up to 1.
 */
#ifndef PP_STUDIES_RESEARCH_ATLAS_ATLAS_RANGES_H
#define PP_STUDIES_RESEARCH_ATLAS_ATLAS_RANGES_H

enum pp_atlas_roof {
    PP_ATLAS_FLAT,
    PP_ATLAS_MONO_PITCH,
    PP_ATLAS_RIDGE,
    PP_ATLAS_ROOFS
};

enum pp_atlas_style {
    PP_ATLAS_USUAL,
    PP_ATLAS_FRENCH,
    PP_ATLAS_CLERESTORY,
    PP_ATLAS_STYLES
};

enum pp_atlas_place {
    PP_ATLAS_ONE_WALL,
    PP_ATLAS_CORNER,
    PP_ATLAS_OPPOSITE,
    PP_ATLAS_ROOF_ONLY,
    PP_ATLAS_PLACES
};

enum pp_atlas_pane {
    PP_ATLAS_CLEAR_SINGLE,
    PP_ATLAS_CLEAR_DOUBLE,
    PP_ATLAS_LOW_E_DOUBLE,
    PP_ATLAS_LOW_E_TRIPLE,
    PP_ATLAS_SOLAR_CONTROL,
    PP_ATLAS_BY_TRANSMITTANCE,
    PP_ATLAS_NO_PANE,
    PP_ATLAS_PANES
};

enum pp_atlas_surroundings {
    PP_ATLAS_NOTHING,
    PP_ATLAS_FAR_SKYLINE,
    PP_ATLAS_NEAR_SKYLINE,
    PP_ATLAS_STREET,
    PP_ATLAS_LIGHT_WELL,
    PP_ATLAS_COURT,
    PP_ATLAS_BALCONY,
    PP_ATLAS_FACADE,
    PP_ATLAS_ASIDE,
    PP_ATLAS_SURROUNDINGS
};

struct pp_atlas_ranges {
    double area_m2[2]; /* floor area, uniform in the logarithm */
    double ratio[2];   /* width divided by depth, uniform in the logarithm */
    double roofs[PP_ATLAS_ROOFS];
    double height_m[2]; /* height of a flat ceiling, uniform in the logarithm; 5 mm are
                         * added to both ends for each m2 of floor */
    double floor[2], walls[2], ceiling[2]; /* reflectances */

    double places[PP_ATLAS_PLACES];
    double rooflights; /* fraction of the rooms with windows in walls that also have
                        * rooflights */
    double styles[PP_ATLAS_STYLES];
    double sill_m[2];
    double least_m;  /* least height of a window */
    double share[2]; /* fraction of a wall's length occupied by windows */
    double panes[PP_ATLAS_PANES];
    double transmittance[2];
    double clean[2]; /* frame factor and maintenance factor, if they are not 1 */
    double reveal_m[2];

    double surroundings[PP_ATLAS_SURROUNDINGS];
    double far_deg[2];             /* angle of a skyline without a distance */
    double near_deg[2], near_m[2]; /* skyline with a distance; the distance is
                                    * uniform in the logarithm */
    double street_m[2], street[2]; /* width of the street, uniform in the logarithm;
                                    * height divided by width */
    double ground[2];              /* reflectance of the ground */
    double snow;                   /* fraction of rooms with snow on the ground */
};

static const struct pp_atlas_ranges pp_atlas_ordinary = {
    .area_m2 = {8.0, 90.0},
    .ratio = {0.5, 2.0},
    .roofs = {0.93, 0.035, 0.035},
    .height_m = {2.35, 3.05},
    .floor = {0.15, 0.45},
    .walls = {0.4, 0.85},
    .ceiling = {0.6, 0.88},
    .places = {0.77, 0.12, 0.07, 0.04},
    .rooflights = 0.03,
    .styles = {0.84, 0.13, 0.03},
    .sill_m = {0.5, 1.15},
    .least_m = 1.0,
    .share = {0.25, 0.95},
    .panes = {0.1, 0.33, 0.3, 0.1, 0.07, 0.1, 0.0},
    .transmittance = {0.5, 0.82},
    .clean = {0.65, 0.95},
    .reveal_m = {0.05, 0.35},
    .surroundings = {0.25, 0.2, 0.17, 0.21, 0.0, 0.03, 0.08, 0.03, 0.03},
    .far_deg = {4.0, 45.0},
    .near_deg = {8.0, 45.0},
    .near_m = {6.0, 50.0},
    .street_m = {8.0, 40.0},
    .street = {0.2, 1.1},
    .ground = {0.08, 0.32},
};

static const struct pp_atlas_ranges pp_atlas_unusual = {
    .area_m2 = {5.0, 140.0},
    .ratio = {0.25, 3.0},
    .roofs = {0.85, 0.08, 0.07},
    .height_m = {2.3, 3.6},
    .floor = {0.08, 0.5},
    .walls = {0.2, 0.9},
    .ceiling = {0.4, 0.9},
    .places = {0.64, 0.16, 0.1, 0.1},
    .rooflights = 0.12,
    .styles = {0.78, 0.12, 0.1},
    .sill_m = {0.3, 1.2},
    .least_m = 0.6,
    .share = {0.15, 0.95},
    .panes = {0.2, 0.3, 0.2, 0.08, 0.06, 0.1, 0.06},
    .transmittance = {0.3, 0.85},
    .clean = {0.6, 0.95},
    .reveal_m = {0.05, 0.4},
    .surroundings = {0.22, 0.2, 0.1, 0.22, 0.035, 0.05, 0.08, 0.045, 0.05},
    .far_deg = {4.0, 60.0},
    .near_deg = {8.0, 60.0},
    .near_m = {4.0, 40.0},
    .street_m = {5.0, 35.0},
    .street = {0.2, 2.0},
    .ground = {0.05, 0.4},
    .snow = 0.04,
};

#endif
