/* fit_rooms.c - evaluates the printed methods, and the geometry that the fitted methods
 * use. */
#include "bench/fit_rooms.h"

#include <math.h>

#include "methods/fitted/fitted_light.h"
#include "methods/fitted/fitted_parts.h"
#include "methods/fitted/fitted_position.h"
#include "methods/method.h"
#include "methods/reflected/bre_terms.h"
#include "model/base/array.h"
#include "tests/lib/traced_rooms.h"

static double logarithm(double value)
{
    return log(fmax(value, 1e-3));
}

static double printed(const struct pp_method *method, const struct pp_traced_room *room,
                      const struct pp_opening *opening)
{
    struct pp_part part = {0};
    if (method->evaluate(room->world, &room->light, opening, NULL, NULL, &part, NULL)
        != PP_OK)
        return NAN;
    return part.value * pp_allowance_factor(method->allowances, opening);
}

/* Sets the values that do not depend on the point. */
static void fill_room(struct pp_fit_opening *to, const struct pp_traced_room *room,
                      const struct pp_opening *opening, struct pp_fitted_light on)
{
    const struct pp_world *world = room->world;
    struct pp_interior all = pp_interior_all(world),
                       floor = pp_interior_role(world, PP_FLOOR);
    struct pp_interior_parts parts = pp_interior_split(world, opening->middle_z_m);
    struct pp_bre_terms bre;
    if (pp_bre_terms(&bre, world, &room->light, opening, NULL) != PP_OK)
        bre.C = NAN;
    double A = all.area_m2, R = all.reflectance, E = on.V + on.C_b + on.C_g;
    double rho_u = parts.upper.reflectance, rho_l = parts.lower.reflectance;
    double A_u = parts.upper.area_m2, A_l = parts.lower.area_m2;
    double ground = room->light.ground_reflectance / 2.0;
    double low = pp_interior_area_below(&opening->inner, world->working_plane_m)
                 / opening->inner.area_m2;
    double flux = opening->glass.diffuse * bre.W * opening->maintenance;
    double low_flux = flux * (1.0 - low + low * floor.reflectance);

    const double light[3] = {on.V, on.C_b, on.C_g};
    to->source[PP_FIT_BRE][0] = printed(&pp_method_bre, room, opening);
    to->source[PP_FIT_FLUX][0] = printed(&pp_method_split_flux, room, opening);
    to->source[PP_FIT_SPHERE][0] = printed(&pp_method_sphere, room, opening);
    to->source[PP_FIT_DF][0] = printed(&pp_method_average_df, room, opening);
    double bre_flux = to->source[PP_FIT_BRE][0]
                      / (bre.C * bre.R_fw + PP_BRE_GROUND_REFLECTANCE / 2.0 * bre.R_cw);
    for (int k = 0; k < 3; k++) {
        bool up = k == 2; /* light of the ground */
        to->source[PP_FIT_SPHERE_NOW][k] =
            flux * sqrt(rho_u) / (A * (1.0 - R)) * light[k] * (up ? 1.0 : rho_l);
        to->source[PP_FIT_BRE_NOW][k] =
            bre_flux * light[k] * (up ? bre.R_cw : bre.R_fw);
        to->source[PP_FIT_BRE_DOWN][k] = bre_flux * light[k] * (up ? 1.0 : bre.R_fw);
        to->source[PP_FIT_FLUX_ALL][k] =
            2.0 * flux * rho_u / (A * (1.0 - R * R)) * light[k] * (up ? 1.0 : rho_l);
        to->source[PP_FIT_FLUX_NOW][k] = to->source[PP_FIT_FLUX][0] * light[k]
                                         * (up ? 1.0 / A_u : rho_l / A_l)
                                         / (ground / A_u + rho_l * bre.C / A_l);
        to->source[PP_FIT_DF_NOW][k] = low_flux * 2.0 * light[k] / (A * (1.0 - R * R));
    }
    to->v = fmax(on.V / 0.396, 0.003);

    double *term = to->term;
    double reveal =
        opening->reveal_m * (1.0 / opening->width_m + 1.0 / opening->height_m);
    term[PP_FIT_ONE] = 1.0;
    term[PP_FIT_UPPER] = logarithm(rho_u);
    term[PP_FIT_LOWER] = logarithm(rho_l);
    term[PP_FIT_SKY] = log(to->v);
    term[PP_FIT_ANGLE] = log(fmax(1.0 - bre.alpha_rad / (PP_PI / 2.0), 0.02));
    term[PP_FIT_PARTS_ALWAYS] = log(A_l / A_u);
    term[PP_FIT_PARTS] = (1.0 - R) * term[PP_FIT_PARTS_ALWAYS];
    term[PP_FIT_REVEAL_ALWAYS] = -reveal;
    term[PP_FIT_REVEAL] = -(1.0 - R) * reveal;
    term[PP_FIT_LOW] = -low;
    term[PP_FIT_LOW_LOST] = -(1.0 - R) * low;
    term[PP_FIT_FLOOR_AREA] = log(A / floor.area_m2);
    term[PP_FIT_GROUND] = -on.C_g / fmax(E, 1e-5);
    term[PP_FIT_CEILING] = logarithm(pp_interior_role(world, PP_CEILING).reflectance);
    term[PP_FIT_WALLS] = logarithm(pp_interior_role(world, PP_WALL).reflectance);
    term[PP_FIT_FLOOR] = logarithm(floor.reflectance);
    term[PP_FIT_MEAN] = logarithm(R);
    term[PP_FIT_LOSS] = 1.0 - R;
    term[PP_FIT_GLASS] = log(bre.W / A);
    to->R = R;
}

/* Sets the values that depend on the point. */
static void fill_place(struct pp_fit_opening *to, const struct pp_world *world,
                       const struct pp_opening *opening,
                       const struct pp_receiver *receiver)
{
    struct pp_fitted_place place = pp_fitted_position_of(world, opening, receiver);
    double h = place.h_r, l = 2.0 * place.w_r * h / (place.w_r + h);
    double sill =
        opening->middle_z_m - opening->height_m / 2.0 - world->working_plane_m;
    double *term = to->term;
    term[PP_FIT_DEEP] = log(place.d_r / h);
    term[PP_FIT_SHALLOW] = (1.0 - to->R) * log1p(h / place.d_r);
    term[PP_FIT_BROAD] = log(place.w_r / h);
    term[PP_FIT_SILL] = sill / h;
    term[PP_FIT_HEAD] = (sill + opening->height_m) / h;
    term[PP_FIT_PLACE] = -place.x / place.d_r;
    double beyond = receiver ? place.x / place.d_r - 0.5 : 0.0;
    term[PP_FIT_PLACE_LOST] = -(1.0 - to->R) * beyond;
    term[PP_FIT_SQUARE] = -place.x * place.x / (place.d_r * place.d_r);
    term[PP_FIT_NEAR] = -log1p(place.x * place.x / (h * h));
    term[PP_FIT_ASIDE] = -place.y / place.w_r;
    term[PP_FIT_BESIDE] = -fmax(place.y - opening->width_m / 2.0, 0.0) / l;
    to->d_r = place.d_r, to->w_r = place.w_r, to->h_r = place.h_r;
    to->x = place.x, to->y = place.y, to->w = opening->width_m;
}

static bool is_covered(const struct pp_traced_room *room)
{
    const struct pp_world *world = room->world;
    if (world->opening_count > PP_FIT_OPENINGS)
        return false;
    for (int i = 0; i < world->opening_count; i++)
        if (pp_method_bre_atlas.refuses(world, &room->light, world->openings + i, NULL))
            return false;
    return true;
}

static void add_room(struct pp_fit_rooms *rooms, int *capacity,
                     const struct pp_traced_room *room)
{
    const struct pp_world *world = room->world;
    struct pp_fit_opening openings[PP_FIT_OPENINGS];
    void *tools;
    memset(openings, 0, sizeof openings);
    if (!is_covered(room)
        || pp_fitted_light_prepare(&tools, world, &room->light, NULL) != PP_OK)
        return;
    for (int k = 0; k < world->opening_count; k++)
        fill_room(openings + k, room, world->openings + k,
                  ((const struct pp_fitted_light *)tools)[k]);
    free(tools);
    for (int i = 0; i < room->count; i++) {
        const struct pp_traced_point *point = room->points + i;
        double off = point->std_error / point->irc / 0.1;
        if (!(point->irc > 2e-5 && off < 3.0))
            continue;
        if (pp_array_reserve(&rooms->rows, capacity, rooms->count + 1,
                             sizeof *rooms->rows, NULL)
            != PP_OK)
            exit(3);
        struct pp_fit_row *row = rooms->rows + rooms->count++;
        *row = (struct pp_fit_row){.room = room->number,
                                   .average = point->index < 0,
                                   .dark = point->dark,
                                   .irc = point->irc,
                                   .df = point->df,
                                   .weight = 1.0 / sqrt(1.0 + off * off),
                                   .count = world->opening_count};
        memcpy(row->openings, openings, sizeof openings);
        for (int k = 0; k < row->count; k++)
            fill_place(row->openings + k, world, world->openings + k,
                       point->index < 0 ? NULL : world->receivers + point->index);
    }
}

struct pp_fit_rooms pp_fit_rooms_read(const char *path)
{
    struct pp_fit_rooms rooms = {0, NULL};
    struct pp_traced_room room;
    int capacity = 0;
    FILE *in = fopen(path, "r");
    if (!in) {
        perror(path);
        exit(1);
    }
    while (pp_traced_rooms_next(in, &room)) {
        add_room(&rooms, &capacity, &room);
        pp_world_destroy(room.world);
    }
    fclose(in);
    return rooms;
}
