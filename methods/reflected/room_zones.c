/* room_zones.c - the form factors and reflectances of the zones, and the formulae that
 * use them. */
#include "methods/reflected/room_zones.h"

#include <math.h>
#include <stddef.h>

#include "methods/lumen/rectangle_factor.h"
#include "methods/reflected/interior.h"

#define OWN(left, right, of, words, list)                                              \
    {                                                                                  \
        .symbol = left, .sum = right, .unit = of, .what = words, .quantities = list    \
    }

#define ZONES                                                                          \
    {"F", PP_UNIT_NUMBER, "form factor between plane and ceiling"},                    \
        {"m", PP_UNIT_NUMBER,                                                          \
         "form factor from the walls to the plane or to the ceiling"},                 \
        {"rho_p", PP_UNIT_NUMBER,                                                      \
         "effective reflectance of the cavity below the "                              \
         "plane"},                                                                     \
        {"rho_c", PP_UNIT_NUMBER, "reflectance of the ceiling"},                       \
    {                                                                                  \
        "rho_v", PP_UNIT_NUMBER, "mean reflectance of the walls above the plane"       \
    }

static const struct pp_formula_quantity of_cavity_below[] = {
    {"S", PP_UNIT_SQUARE_METRE, "area of the working plane"},
    {"A_l", PP_UNIT_SQUARE_METRE, "area of surfaces below the working plane"},
    {"rho_l", PP_UNIT_NUMBER, "mean reflectance of these surfaces"},
    {0},
};
static const struct pp_formula_quantity of_cavity_above[] = {
    {"S", PP_UNIT_SQUARE_METRE, "area of the working plane"},
    {"A_c", PP_UNIT_SQUARE_METRE, "area of the ceiling, openings included"},
    {"rho_a", PP_UNIT_NUMBER, "mean reflectance of the ceiling (openings: 0.1)"},
    {0},
};
static const struct pp_formula_quantity of_m[] = {
    {"S", PP_UNIT_SQUARE_METRE, "area of the working plane"},
    {"F", PP_UNIT_NUMBER, "form factor between plane and ceiling"},
    {"A_w", PP_UNIT_SQUARE_METRE, "area of the walls above the plane"},
    {0},
};
static const struct pp_formula_quantity of_zones[] = {ZONES, {0}};
static const struct pp_formula_quantity of_u_c[] = {
    ZONES,
    {"u_w", PP_UNIT_NUMBER,
     "fraction of the light on the walls that reaches the plane"},
    {0}};
static const struct pp_formula_quantity of_u_p[] = {
    ZONES,
    {"u_w", PP_UNIT_NUMBER,
     "fraction of the light on the walls that reaches the plane"},
    {"u_c", PP_UNIT_NUMBER,
     "fraction of the light on the ceiling that reaches the plane"},
    {0},
};

const struct pp_formula pp_room_zones_below =
    OWN("rho_p", "rho_l S / (A_l (1 - rho_l) + rho_l S)", PP_UNIT_NUMBER,
        "effective reflectance of the cavity below the plane", of_cavity_below);
const struct pp_formula pp_room_zones_above =
    OWN("rho_c", "rho_a S / (A_c (1 - rho_a) + rho_a S)", PP_UNIT_NUMBER,
        "effective reflectance of the ceiling cavity", of_cavity_above);
const struct pp_formula pp_room_zones_m =
    OWN("m", "S (1 - F) / A_w", PP_UNIT_NUMBER,
        "form factor from the walls to the plane or to the ceiling", of_m);
const struct pp_formula pp_room_zones_u_w =
    OWN("u_w", "rho_v m (1 + rho_c F) / (1 - rho_v (1 - 2 m) - rho_c rho_v (1 - F) m)",
        PP_UNIT_NUMBER, "fraction of the light on the walls that reaches the plane",
        of_zones);
const struct pp_formula pp_room_zones_u_c =
    OWN("u_c", "rho_c (F + (1 - F) u_w)", PP_UNIT_NUMBER,
        "fraction of the light on the ceiling that reaches the plane", of_u_c);
const struct pp_formula pp_room_zones_u_p =
    OWN("u_p", "F u_c + (1 - F) u_w", PP_UNIT_NUMBER,
        "fraction of the light from the plane that returns to it", of_u_p);

/* Perimeter of the working plane (m). */
static double outline_m(const struct pp_region *plane)
{
    double sum = 0.0;
    for (int r = 0; r < plane->count; r++)
        for (int i = 0, n = plane->rings[r].count; i < n; i++) {
            const double *a = plane->rings[r].xy[i];
            const double *b = plane->rings[r].xy[(i + 1) % n];
            sum += hypot(b[0] - a[0], b[1] - a[1]);
        }
    return sum;
}

/* F of the rectangle with the plane's area and perimeter; of a square if no rectangle
 * of that area has so short a perimeter. */
static double form_factor(double area_m2, double outline, double height_m)
{
    double half = outline / 4.0, root = sqrt(fmax(half * half - area_m2, 0.0));
    double a = root > 0.0 ? half + root : sqrt(area_m2), b = area_m2 / a;
    if (!(height_m > 1e-6 * b))
        return 1.0;
    const struct pp_aligned_rectangle low = {2, {0, 0, 0}, {a, b, 0}};
    const struct pp_aligned_rectangle high = {2, {0, 0, height_m}, {a, b, height_m}};
    return pp_rectangle_factor_exchange_area(&low, &high) / area_m2;
}

double pp_room_zones_put(struct pp_worksheet *sheet, const struct pp_world *world)
{
    double z = world->working_plane_m, S = pp_region_area(&world->plane);
    struct pp_interior low = pp_interior_split_without(world, z, -1).lower;
    struct pp_interior ceiling = pp_interior_role_above(world, PP_CEILING, z);
    struct pp_interior walls = pp_interior_role_above(world, PP_WALL, z);
    double height_m = walls.area_m2 / outline_m(&world->plane);
    pp_worksheet_put(sheet, PP_UNIT_SQUARE_METRE, S, "S", "area of the working plane");
    pp_worksheet_put(sheet, PP_UNIT_SQUARE_METRE, low.area_m2, "A_l",
                     "area of surfaces below the working plane");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, low.reflectance, "rho_l",
                     "mean reflectance of these surfaces");
    pp_worksheet_work(sheet, &pp_room_zones_below,
                      "effective reflectance of the cavity below the plane");
    pp_worksheet_put(sheet, PP_UNIT_SQUARE_METRE, ceiling.area_m2, "A_c",
                     "area of the ceiling");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, ceiling.reflectance, "rho_a",
                     "mean reflectance of the ceiling (openings: 0.1)");
    pp_worksheet_work(sheet, &pp_room_zones_above,
                      "effective reflectance of the ceiling cavity");
    pp_worksheet_put(sheet, PP_UNIT_SQUARE_METRE, fmax(walls.area_m2, 1e-9), "A_w",
                     "area of the walls above the plane");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER, walls.reflectance, "rho_v",
                     "mean reflectance of the walls (openings: 0.1)");
    pp_worksheet_put(sheet, PP_UNIT_NUMBER,
                     form_factor(S, outline_m(&world->plane), height_m), "F",
                     "form factor between plane and ceiling, %.2f m apart", height_m);
    pp_worksheet_work(sheet, &pp_room_zones_m,
                      "form factor from the walls to the plane or to the ceiling");
    pp_worksheet_work(sheet, &pp_room_zones_u_w,
                      "fraction of the light on the walls that reaches the plane");
    pp_worksheet_work(sheet, &pp_room_zones_u_c,
                      "fraction of the light on the ceiling that reaches the plane");
    pp_worksheet_work(sheet, &pp_room_zones_u_p,
                      "fraction of the light from the plane that returns to it");
    return height_m;
}
