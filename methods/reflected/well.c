/* well.c - flux transfer in a straight shaft. */
#include "methods/reflected/well.h"

#include <math.h>

#include "methods/lumen/rectangle_factor.h"
#include "methods/reflected/point_factor.h"
#include "methods/refusals.h"
#include "model/light/graded_sky.h"

enum {
    BANDS = PP_WELL_BANDS, /* twice as many change the efficiency by less than 0.002 */
    ALTITUDES = 48,        /* altitudes of light that passes without reflection */
    AZIMUTHS = 12,         /* azimuths in a quarter of the circle */
    TOP = BANDS, /* the glass seen from below, a further zone after the bands */
    FOOT,        /* the floor of an atrium; the foot of a rooflight's well is black */
    ZONES,
};

bool pp_well_is(const struct pp_opening *opening)
{
    return opening->reveal_m > 0.0 && pp_refusals_unless_vertical(opening) != NULL;
}

double pp_well_index(const struct pp_well_shape *shape)
{
    return shape->depth_m * (shape->width_m + shape->length_m)
           / (2.0 * shape->width_m * shape->length_m);
}

/* Fraction of the well's section that overlaps the section shifted by x and y (in units
 * of its sides). */
static double overlap(double x, double y)
{
    return x < 1.0 && y < 1.0 ? (1.0 - x) * (1.0 - y) : 0.0;
}

/* through[i]: fraction of the light that passes section i of the shaft (0 is the top)
 * without touching the sides. Directions are at equal steps of azimuth and of the sine
 * s of the angle to the shaft, with weight s ds. Returns the transmittance of the glass
 * for this light. */
static double pass_straight(double through[BANDS + 1],
                            const struct pp_well_shape *shape, double b,
                            const struct pp_glass *glass)
{
    double sum = 0.0, on_glass = 0.0;
    for (int i = 0; i <= BANDS; i++)
        through[i] = 0.0;
    for (int k = 0; k < ALTITUDES; k++) {
        double sine = (k + 0.5) / ALTITUDES, cosine = sqrt(1.0 - sine * sine);
        double light = sine * pp_graded_sky_luminance(b, cosine);
        double weight = light * pp_glass_transmittance(glass, cosine);
        on_glass += light * AZIMUTHS;
        double aside_m = shape->depth_m / BANDS * sine / cosine;
        for (int j = 0; j < AZIMUTHS; j++) {
            double azimuth_rad = (j + 0.5) / AZIMUTHS * PP_PI / 2.0;
            double x = aside_m * cos(azimuth_rad) / shape->width_m;
            double y = aside_m * sin(azimuth_rad) / shape->length_m;
            for (int i = 0; i <= BANDS; i++)
                through[i] += weight * overlap(i * x, i * y);
            sum += weight;
        }
    }
    for (int i = 0; i <= BANDS; i++)
        through[i] /= sum;
    return sum / on_glass;
}

/* factor[i]: form factor between sections i bands apart. */
static void form_factors(double factor[BANDS + 1], const struct pp_well_shape *shape)
{
    double a = shape->width_m, b = shape->length_m;
    const struct pp_aligned_rectangle foot = {2, {0, 0, 0}, {a, b, 0}};
    factor[0] = 1.0;
    for (int i = 1; i <= BANDS; i++) {
        double z = shape->depth_m * i / BANDS;
        const struct pp_aligned_rectangle above = {2, {0, 0, z}, {a, b, z}};
        factor[i] = pp_rectangle_factor_exchange_area(&foot, &above) / (a * b);
    }
}

/* Solves M x = y in place for a diagonally dominant matrix. */
static void solve(double M[ZONES][ZONES], double y[ZONES])
{
    for (int i = 0; i < ZONES; i++)
        for (int k = i + 1; k < ZONES; k++) {
            double times = M[k][i] / M[i][i];
            for (int j = i; j < ZONES; j++)
                M[k][j] -= times * M[i][j];
            y[k] -= times * y[i];
        }
    for (int i = ZONES - 1; i >= 0; i--) {
        for (int j = i + 1; j < ZONES; j++)
            y[i] -= M[i][j] * y[j];
        y[i] /= M[i][i];
    }
}

double pp_well_glass_back(const struct pp_glass *glass)
{
    double sum = 0.0;
    for (int k = 0; k < ALTITUDES; k++) {
        double sine = (k + 0.5) / ALTITUDES;
        sum += 2.0 * sine / ALTITUDES
               * pp_glass_reflectance(glass, sqrt(1.0 - sine * sine));
    }
    return sum;
}

/* All bands have the same height, so that the exchange between two bands depends only
 * on their distance. The exchange is calculated from form factors F between sections of
 * the shaft; `section` is the area of a section divided by that of a band:
 *
 *     i to j     section (F(m - 1) - 2 F(m) + F(m + 1)),  m = |i - j| > 0
 *     to itself  1 - 2 section (1 - F(1))
 *     to the foot, n bands below its upper edge: section (F(n - 1) - F(n))
 *
 * The exchange with the top has the same form. top, foot: reflectances seen from within.
 * on_zone: in, light that comes straight from the sky; out, all light.
 */
static void exchange(double on_zone[ZONES], const double F[BANDS + 1],
                     const struct pp_well_shape *shape, double top, double foot)
{
    double M[ZONES][ZONES], section = BANDS / (4.0 * pp_well_index(shape));
    for (int i = 0; i < BANDS; i++) {
        double to_top = F[i] - F[i + 1], to_foot = F[BANDS - 1 - i] - F[BANDS - i];
        M[i][TOP] = -top * to_top;
        M[TOP][i] = -shape->sides * section * to_top;
        M[i][FOOT] = -foot * to_foot;
        M[FOOT][i] = -shape->sides * section * to_foot;
        for (int j = 0; j < BANDS; j++) {
            int m = i > j ? i - j : j - i;
            double sent = m == 0 ? 1.0 - 2.0 * section * (1.0 - F[1])
                                 : section * (F[m - 1] - 2.0 * F[m] + F[m + 1]);
            M[i][j] = (i == j) - shape->sides * sent;
        }
    }
    M[TOP][TOP] = M[FOOT][FOOT] = 1.0;
    M[TOP][FOOT] = -foot * F[BANDS];
    M[FOOT][TOP] = -top * F[BANDS];
    solve(M, on_zone);
}

struct pp_well_efficiency pp_well_efficiency(const struct pp_well_shape *shape,
                                             double b, const struct pp_glass *glass)
{
    double T[BANDS + 1], F[BANDS + 1], on_zone[ZONES] = {0.0};
    pass_straight(T, shape, b, glass);
    form_factors(F, shape);
    double section = BANDS / (4.0 * pp_well_index(shape)),
           back = pp_well_glass_back(glass);
    for (int i = 0; i < BANDS; i++)
        on_zone[i] = T[i] - T[i + 1];
    exchange(on_zone, F, shape, back, 0.0);
    struct pp_well_efficiency efficiency = {.whole = T[BANDS], .direct = T[BANDS]};
    efficiency.whole += back * on_zone[TOP] * F[BANDS];
    for (int i = 0; i < BANDS; i++)
        efficiency.whole +=
            shape->sides * on_zone[i] * section * (F[BANDS - 1 - i] - F[BANDS - i]);
    return efficiency;
}

void pp_well_add_sky(struct pp_well_flux *flux, const struct pp_well_shape *shape,
                     double b, const struct pp_glass *glass, double share)
{
    double T[BANDS + 1];
    double entering = share * pass_straight(T, shape, b, glass);
    for (int i = 0; i < BANDS; i++)
        flux->bands[i] += entering * (T[i] - T[i + 1]);
    flux->foot += entering * T[BANDS];
}

void pp_well_exchange(struct pp_well_flux *flux, const struct pp_well_shape *shape,
                      double top, double foot)
{
    double F[BANDS + 1], on_zone[ZONES];
    form_factors(F, shape);
    for (int i = 0; i < BANDS; i++)
        on_zone[i] = flux->bands[i];
    on_zone[TOP] = flux->top;
    on_zone[FOOT] = flux->foot;
    exchange(on_zone, F, shape, top, foot);
    for (int i = 0; i < BANDS; i++)
        flux->bands[i] = on_zone[i];
    flux->top = on_zone[TOP];
    flux->foot = on_zone[FOOT];
}

static struct pp_well_shape shape_of(const struct pp_world *world,
                                     const struct pp_opening *opening)
{
    struct pp_well_shape shape = {opening->width_m, opening->height_m,
                                  opening->reveal_m,
                                  world->surfaces[opening->face].front};
    if (!opening->rectangle) {
        const struct pp_polygon *foot = &opening->inner;
        double round_m = 0.0;
        for (int i = 0; i < foot->count; i++)
            round_m += pp_vec_length(
                pp_vec_sub(foot->vertices[(i + 1) % foot->count], foot->vertices[i]));
        shape.width_m = shape.length_m = 4.0 * foot->area_m2 / round_m;
    }
    return shape;
}

struct pp_well_efficiency pp_well_of(const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     const struct pp_opening *opening)
{
    if (!pp_well_is(opening))
        return (struct pp_well_efficiency){1.0, 1.0};
    bool level = sin(opening->slope_rad) < 1e-6;
    bool even = !level || opening->glass.diffusing;
    struct pp_well_shape shape = shape_of(world, opening);
    return pp_well_efficiency(&shape, even ? 0.0 : light->sky.gradation,
                              &opening->glass);
}

void pp_well_put(struct pp_worksheet *sheet, const struct pp_world *world,
                 const struct pp_outside_light *light, const struct pp_opening *opening)
{
    struct pp_well_shape shape = shape_of(world, opening);
    struct pp_well_efficiency N = pp_well_of(world, light, opening);
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, pp_well_index(&shape), "w", "well index");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, shape.sides, "rho_w",
                     "reflectance of the sides of the well");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, N.whole, "N",
                     "fraction of the entering light that leaves the well");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, N.direct, "N_d",
                     "fraction that leaves the well without reflection from its sides");
}

double pp_well_foot_to_plane(const struct pp_world *world,
                             const struct pp_opening *opening)
{
    return pp_point_factor(pp_polygon_middle(&opening->inner), opening->inner.normal,
                           &world->plane, world->working_plane_m);
}

void pp_well_put_foot(struct pp_worksheet *sheet, const struct pp_world *world,
                      const struct pp_opening *opening)
{
    pp_worksheet_put(
        sheet, PP_UNIT_NUMBER, pp_well_foot_to_plane(world, opening), "f",
        "fraction of the light from the foot of the well that falls on the plane");
    pp_worksheet_put(sheet, PP_UNIT_SQUARE_METRE, pp_region_area(&world->plane), "S",
                     "area of the working plane");
}
