/* test_outdoor_cells.c - the cells of outdoor surfaces suffice for the surfaces near a
 * room. */
#include "simulate/sampling/hash.h"
#include "simulate/scene/light_scene_parts.h"
#include "simulate/year/outdoor_cells.h"
#include "simulate/year/year_batch.h"
#include "tests/lib/near.h"

/* A street 12 m wide, in front of a room of 4 x 6 x 3 m on the upper floor of a house;
 * positions in metres from the room's centre. */
static const double own_y = -3.0, opposite_y = -15.0, ground_z = -4.5, own_top_z = 7.5,
                    opposite_top_z = 5.5;

static double draw(uint64_t *dice)
{
    *dice = pp_hash(*dice, 1);
    return (double)(*dice >> 11) * 0x1p-53;
}

/* A direction with a density proportional to the cosine to the normal, which is an
 * axis. */
static struct pp_vec3 lobe(struct pp_vec3 normal, uint64_t *dice)
{
    double u = draw(dice), turn = 2.0 * PP_PI * draw(dice);
    double a = sqrt(u) * cos(turn), b = sqrt(u) * sin(turn), c = sqrt(1.0 - u);
    return fabs(normal.z) > 0.5 ? pp_vec(a, b, c * normal.z)
                                : pp_vec(a, c * normal.y, b);
}

/* The next surface of the street along u; false for the sky. */
static bool next_place(struct pp_lit_point *at, struct pp_vec3 u)
{
    double ground = u.z < 0.0 ? (ground_z - at->point.z) / u.z : INFINITY;
    double wall_y = u.y < 0.0 ? opposite_y : own_y;
    double wall = (wall_y - at->point.y) / u.y;
    double top_z = u.y < 0.0 ? opposite_top_z : own_top_z;
    if (!(wall > 0.0) || at->point.z + wall * u.z > top_z)
        wall = INFINITY;
    double distance = fmin(ground, wall);
    if (!isfinite(distance))
        return false;
    at->point = pp_vec_along(at->point, distance, u);
    at->normal = ground < wall ? pp_vec(0.0, 0.0, 1.0)
                               : pp_vec(0.0, u.y < 0.0 ? 1.0 : -1.0, 0.0);
    return true;
}

/* In cells shared by all surfaces, one position represents sunlit and shaded ground.
 * The light in such cells must be negligible. */
static void cells_near_a_street_are_not_shared(void **state)
{
    (void)state;
    static struct pp_lit_point points[PP_YEAR_OUTDOOR_CELLS];
    const struct pp_light_scene scene = {.size_m = 3.0};
    struct pp_outdoor_cells cells;
    pp_outdoor_cells_init(&cells, &scene, points, PP_YEAR_OUTDOOR_CELLS, 1);
    double all = 0.0, shared = 0.0;
    uint64_t dice = 7;
    for (int i = 0; i < 100000; i++) {
        struct pp_lit_point at = {
            pp_vec(3.0 * draw(&dice) - 1.5, own_y, 1.8 * draw(&dice) - 0.6),
            pp_vec(0.0, -1.0, 0.0), PP_OUTDOORS};
        double weight = 1.0;
        while (weight > 1e-3 && next_place(&at, lobe(at.normal, &dice))) {
            weight *= 0.3; /* reflectance */
            all += weight;
            if (pp_outdoor_cells_find(&cells, &at, weight) >= PP_YEAR_OUTDOOR_CELLS - 6)
                shared += weight;
        }
    }
    assert_true(shared < 0.02 * all);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cells_near_a_street_are_not_shared),
    };
    add_tests(tests, NULL, NULL);
}
