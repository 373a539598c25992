/* test_gather_cells.c - cells and rays of the cosine lobe together give the value of a
 * closed form. */
#include "simulate/fast/gather_cells.h"

#include <math.h>
#include <stdlib.h>

#include "simulate/research/radiosity/form_factor.h"
#include "simulate/fast/path.h"
#include "tests/lib/guessed_room.h"

/* The walls are the only rectangles; one of them has two openings. */
#define TRAPEZIUM                                                                      \
    "<room version='1'><plan height='2.6'><vertex x='0' y='0'/><vertex x='4' y='0'/>"  \
    "<vertex x='3' y='7'/><vertex x='0' y='7'/></plan>"                                \
    "<window wall='1' left='0.4' sill='0.9' width='1.1' height='1.2'/>"                \
    "<window wall='1' left='2.2' sill='0.5' width='0.9' height='1.9'/></room>"

/* Sets the estimated radiosity of one face, and of all others. */
static void guess(struct pp_test_guessed_room *room, int face, double there,
                  double elsewhere)
{
    for (int i = 0; i < room->world->face_count; i++) {
        const struct pp_control_variate_grid *grid = &room->guess->grids[i][0];
        for (int k = 0; k < grid->columns * grid->rows; k++)
            room->guess->values[grid->first + k] = i == face ? there : elsewhere;
    }
}

/* The face with this normal, which points into the room. */
static int face_with(const struct pp_test_guessed_room *room, struct pp_vec3 normal)
{
    int face = 0;
    while (pp_vec_dot(room->world->surfaces[face].outline.normal, normal) < 0.99)
        face++;
    return face;
}

/* Form factor to the surface of the face without its openings. */
static double face_factor(const struct pp_test_guessed_room *room, int face,
                          const struct pp_start *start)
{
    const struct pp_polygon *outline = &room->world->surfaces[face].outline;
    struct pp_vec3 corners[8];
    for (int i = 0; i < outline->count; i++)
        corners[i] = pp_vec_sub(outline->vertices[i], room->scene->centre);
    double factor =
        pp_form_factor(start->position, start->normal, corners, outline->count);
    for (int i = 0; i < room->scene->pane_count; i++) {
        const struct pp_target *pane = &room->scene->panes[i].target;
        if (room->world->openings[i].face != face)
            continue;
        corners[0] = pane->corner;
        corners[1] = pp_vec_along(corners[0], pane->width_m, pane->along);
        corners[2] = pp_vec_along(corners[1], pane->height_m, pane->up);
        corners[3] = pp_vec_along(corners[0], pane->height_m, pane->up);
        factor -= pp_form_factor(start->position, start->normal, corners, 4);
    }
    return factor;
}

struct gathered {
    double value, error, by_cells;
};

/* Gathers with 32 nets, and with 256 rays for each. */
static struct gathered gather(const struct pp_test_guessed_room *room,
                              const struct pp_start *start)
{
    enum { NETS = 32, RAYS = 256 };
    struct pp_gather_cells *cells;
    struct gathered found = {0.0, 0.0, 0.0};
    double squares = 0.0;
    assert_non_null(room->scene->convex);
    assert_int_equal(pp_gather_cells_create(&cells, room->scene, room->guess, NULL),
                     PP_OK);
    double *net = malloc(pp_gather_cells_size(cells) * sizeof *net);
    assert_non_null(net);
    struct pp_path_state path =
        pp_path_state(room->scene, room->environment, room->guess);
    path.cells = cells;
    path.net = net;
    for (int i = 0; i < NETS; i++) {
        double u[2], sum = 0.0;
        pp_sobol_sequence_init(&path.light.sequence, &room->sobol, (uint64_t)i);
        pp_sobol_sequence_draw(&path.light.sequence, 0, 7, 2, u);
        pp_gather_cells_draw(cells, &path.light, u, net);
        path.light.index = 0;
        pp_path_gather(&path, start, RAYS, &sum);
        double far = pp_path_gather_cells(&path, start), all = far + sum / RAYS;
        found.by_cells += far / NETS;
        found.value += all / NETS;
        squares += all * all / NETS;
    }
    found.error = sqrt(fmax(0.0, squares - found.value * found.value) / (NETS - 1));
    free(net);
    pp_gather_cells_destroy(cells);
    return found;
}

static struct pp_start start_at(const struct pp_test_guessed_room *room,
                                struct pp_vec3 point, struct pp_vec3 normal)
{
    return (struct pp_start){.position = pp_vec_sub(point, room->scene->centre),
                             .normal = normal};
}

/* If only one face emits, with an exitance of 1, a point gathers the form factor to
 * this face: from the middle, a centimetre from a wall, in a corner of the floor, and
 * tilted. */
static void a_face_is_gathered_by_its_form_factor(void **state)
{
    (void)state;
    static const struct {
        struct pp_vec3 point, normal;
    } at[] = {{{1.7, 3.1, 0.8}, {0.0, 0.0, 1.0}},
              {{0.01, 4.9, 0.8}, {0.0, 0.0, 1.0}},
              {{0.02, 6.97, 0.0}, {0.0, 0.0, 1.0}},
              {{1.1, 5.9, 1.9}, {0.48, -0.64, -0.6}}};
    struct pp_test_guessed_room room;
    pp_test_guessed_room_init(&room, TRAPEZIUM);
    for (int face = 0; face < room.world->face_count; face++)
        for (size_t i = 0; i < sizeof at / sizeof *at; i++) {
            struct pp_start start = start_at(&room, at[i].point, at[i].normal);
            guess(&room, face, 1.0, 0.0);
            struct gathered found = gather(&room, &start);
            assert_near(found.value, face_factor(&room, face, &start),
                        4.0 * found.error + 1e-6);
            assert_near(found.error, 0.0, 3e-3);
        }
    pp_test_guessed_room_clear(&room);
}

/* Above the centre of a floor of 4 x 4 m, 2 m below the ceiling: four corners, each
 * 1/(2 pi) 2 (1/sqrt 2) atan(1/sqrt 2) = 0.138532, give 0.554126. */
static void a_ceiling_is_gathered_by_hand(void **state)
{
    (void)state;
    struct pp_test_guessed_room room;
    pp_test_guessed_room_init(
        &room, "<room version='1'><plan width='4' depth='4' height='2.7'/></room>");
    struct pp_start start =
        start_at(&room, pp_vec(2.0, 2.0, 0.7), pp_vec(0.0, 0.0, 1.0));
    guess(&room, face_with(&room, pp_vec(0.0, 0.0, -1.0)), 3.0, 1.0);
    struct gathered found = gather(&room, &start);
    assert_near(found.value, 1.0 + 2.0 * 0.554126, 4.0 * found.error + 2e-6);
    assert_near(found.error, 0.0, 2e-3);
    pp_test_guessed_room_clear(&room);
}

/* A uniform estimate is gathered by the lobe without noise. */
static void an_even_guess_is_left_to_the_lobe(void **state)
{
    (void)state;
    struct pp_test_guessed_room room;
    pp_test_guessed_room_init(
        &room, "<room version='1'><plan width='4' depth='4' height='2.7'/></room>");
    struct pp_start start =
        start_at(&room, pp_vec(0.3, 2.0, 0.7), pp_vec(0.6, 0.0, 0.8));
    guess(&room, 0, 0.7, 0.7);
    struct gathered found = gather(&room, &start);
    assert_near(found.value, 0.7, 1e-12);
    assert_near(found.by_cells, 0.0, 0.0);
    pp_test_guessed_room_clear(&room);
}

/* From the back of a room the cells gather the light of the window wall; the light of a
 * wall a centimetre away mostly comes from rays of the lobe. */
static void cells_gather_from_far(void **state)
{
    (void)state;
    struct pp_test_guessed_room room;
    pp_test_guessed_room_init(&room, TRAPEZIUM);
    struct pp_start start =
        start_at(&room, pp_vec(0.01, 6.5, 0.8), pp_vec(0.0, 0.0, 1.0));
    guess(&room, face_with(&room, pp_vec(0.0, 1.0, 0.0)), 1.0, 0.0);
    struct gathered far = gather(&room, &start);
    assert_true(far.by_cells > 0.9 * far.value);
    guess(&room, face_with(&room, pp_vec(1.0, 0.0, 0.0)), 1.0, 0.0);
    struct gathered near = gather(&room, &start);
    assert_true(near.by_cells < 0.3 * near.value);
    pp_test_guessed_room_clear(&room);
}

TEST_FILE
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_face_is_gathered_by_its_form_factor),
        cmocka_unit_test(a_ceiling_is_gathered_by_hand),
        cmocka_unit_test(an_even_guess_is_left_to_the_lobe),
        cmocka_unit_test(cells_gather_from_far),
    };
    add_tests(tests, NULL, NULL);
}
