/* test_net_chart.c - the net of a model: every panel is its surface to scale and not
 * mirrored, panels do not overlap, each edge is folded, glued or taped, and drawn edges
 * have the correct lengths. */
#include "charts/net/net_chart.h"

#include <string.h>

#include "charts/net/net_unfold.h"
#include "model/geometry/clipper.h"
#include "tests/lib/room_of.h"
#include "tests/lib/strokes.h"

#define PAPER_MM 0.02

static const char box[] =
    "<room version=\"1\"><plan width=\"4.23\" depth=\"5.41\" height=\"2.87\"/>"
    "<window wall=\"south\" left=\"0.37\" sill=\"0.93\" width=\"1.31\" "
    "height=\"1.57\"/>"
    "<rooflight x=\"1.1\" y=\"2.2\" width=\"1.21\" depth=\"0.83\"/></room>";
static const char bent[] =
    "<room version=\"1\"><plan height=\"2.61\"><vertex x=\"0\" y=\"0\"/>"
    "<vertex x=\"5.43\" y=\"0\"/><vertex x=\"5.43\" y=\"3.57\"/>"
    "<vertex x=\"3.11\" y=\"3.57\"/><vertex x=\"3.11\" y=\"6.67\"/>"
    "<vertex x=\"0\" y=\"6.67\"/></plan>"
    "<window wall=\"1\" left=\"1.1\" sill=\"0.5\" width=\"2.83\" "
    "height=\"1.71\"/></room>";
static const char lean_to[] =
    "<room version=\"1\"><envelope>"
    "<face role=\"floor\" name=\"f\"><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex "
    "x=\"4.1\" y=\"0\" "
    "z=\"0\"/>"
    "<vertex x=\"4.1\" y=\"3.3\" z=\"0\"/><vertex x=\"0\" y=\"3.3\" z=\"0\"/></face>"
    "<face role=\"ceiling\" name=\"c\"><vertex x=\"0\" y=\"0\" z=\"2.2\"/><vertex "
    "x=\"0\" "
    "y=\"3.3\" z=\"3.7\"/>"
    "<vertex x=\"4.1\" y=\"3.3\" z=\"3.7\"/><vertex x=\"4.1\" y=\"0\" "
    "z=\"2.2\"/></face>"
    "<face role=\"wall\" name=\"low\"><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"0\" "
    "y=\"0\" z=\"2.2\"/>"
    "<vertex x=\"4.1\" y=\"0\" z=\"2.2\"/><vertex x=\"4.1\" y=\"0\" z=\"0\"/></face>"
    "<face role=\"wall\" name=\"right\"><vertex x=\"4.1\" y=\"0\" z=\"0\"/><vertex "
    "x=\"4.1\" y=\"0\" z=\"2.2\"/>"
    "<vertex x=\"4.1\" y=\"3.3\" z=\"3.7\"/><vertex x=\"4.1\" y=\"3.3\" "
    "z=\"0\"/></face>"
    "<face role=\"wall\" name=\"high\"><vertex x=\"4.1\" y=\"3.3\" z=\"0\"/><vertex "
    "x=\"4.1\" y=\"3.3\" z=\"3.7\"/>"
    "<vertex x=\"0\" y=\"3.3\" z=\"3.7\"/><vertex x=\"0\" y=\"3.3\" z=\"0\"/></face>"
    "<face role=\"wall\" name=\"left\"><vertex x=\"0\" y=\"3.3\" z=\"0\"/><vertex "
    "x=\"0\" y=\"3.3\" z=\"3.7\"/>"
    "<vertex x=\"0\" y=\"0\" z=\"2.2\"/><vertex x=\"0\" y=\"0\" z=\"0\"/></face>"
    "</envelope></room>";

static const char covered[] =
    "<room version=\"1\"><plan width=\"4.23\" depth=\"5.41\" height=\"2.87\"/>"
    "<window wall=\"south\" left=\"0.37\" sill=\"0.93\" width=\"1.31\" "
    "height=\"1.57\"/>"
    "<door wall=\"south\" left=\"2.2\" width=\"0.97\" height=\"2.03\"/>"
    "<dado wall=\"south\" height=\"0.71\" reflectance=\"0.25\"/></room>";

static const struct {
    const char *room;
    double mm_per_m, area[2]; /* width and height of a sheet (mm); larger panels are
                               * cut */
    int pieces_least, pieces_most;
} cases[] = {
    {box, 20.0, {390.0, 500.0}, 1, 1},      {box, 50.0, {260.0, 340.0}, 4, 6},
    {bent, 20.0, {390.0, 500.0}, 1, 2},     {lean_to, 20.0, {390.0, 500.0}, 1, 1},
    {lean_to, 50.0, {180.0, 170.0}, 6, 24}, {bent, 50.0, {150.0, 120.0}, 12, 40},
};
enum { CASES = sizeof cases / sizeof cases[0] };

static struct pp_world *opened(struct pp_net *net, int index)
{
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, cases[index].room);
    assert_non_null(world);
    assert_int_equal(
        pp_net_unfold(net, world, cases[index].mm_per_m, cases[index].area, NULL),
        PP_OK);
    return world;
}

static double area_of(const struct pp_net_panel *panel)
{
    double sum = 0.0;
    for (int i = 0; i < panel->count; i++) {
        double a[2], b[2];
        pp_net_panels_corner(panel, i, a);
        pp_net_panels_corner(panel, i + 1, b);
        sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
    return sum;
}

/* Distances between all corners are those of the room. A mirrored panel would have a
 * negative area. The parts of a surface have its total area. */
static void panels_are_their_faces_to_scale_seen_from_inside(void **state)
{
    (void)state;
    for (int c = 0; c < CASES; c++) {
        struct pp_net net;
        struct pp_world *world = opened(&net, c);
        double mm = cases[c].mm_per_m;
        for (int f = 0; f < world->face_count; f++) {
            const struct pp_polygon *face = &world->surfaces[f].outline;
            double area = 0.0;
            for (int p = 0; p < net.panels.count; p++) {
                const struct pp_net_panel *panel = &net.panels.list[p];
                if (panel->face != f)
                    continue;
                area += area_of(panel);
                assert_true(area_of(panel) > 0.0);
                for (int i = 0; panel->parts == 1 && i < face->count; i++)
                    for (int k = 0; k < i; k++) {
                        double a[2], b[2];
                        pp_net_panels_point(&net.panels, panel, face->vertices[i], a);
                        pp_net_panels_corner(panel, k, b);
                        assert_near(hypot(a[0] - b[0], a[1] - b[1]),
                                    mm
                                        * pp_vec_length(pp_vec_sub(face->vertices[i],
                                                                   face->vertices[k])),
                                    1e-6);
                    }
            }
            assert_near(area, face->area_m2 * mm * mm, 1e-3);
        }
        pp_net_unfold_clear(&net);
        pp_world_destroy(world);
    }
}

static void pieces_are_as_many_as_they_must_and_lie_within_their_sheets(void **state)
{
    (void)state;
    for (int c = 0; c < CASES; c++) {
        struct pp_net net;
        struct pp_world *world = opened(&net, c);
        assert_in_range(net.piece_count, cases[c].pieces_least, cases[c].pieces_most);
        for (int i = 0; i < net.piece_count; i++) {
            const struct pp_net_piece *p = &net.pieces[i];
            for (int k = 0; k < 2; k++) {
                double end = p->place[k] + p->extent.high[k] - p->extent.low[k];
                assert_true(p->place[k] >= -1e-6 && end <= cases[c].area[k] + 1e-6);
                for (int j = 0; j < i && k == 0; j++) {
                    const struct pp_net_piece *q = &net.pieces[j];
                    bool apart = p->sheet != q->sheet;
                    for (int m = 0; m < 2; m++)
                        apart = apart
                                || p->place[m] >= q->place[m] + q->extent.high[m]
                                                      - q->extent.low[m]
                                || q->place[m] >= p->place[m] + p->extent.high[m]
                                                      - p->extent.low[m];
                    assert_true(apart);
                }
            }
        }
        pp_net_unfold_clear(&net);
        pp_world_destroy(world);
    }
}

/* Folded edges coincide; any other edge has a tab on one side, or is taped. */
static void every_edge_is_folded_glued_or_taped(void **state)
{
    (void)state;
    for (int c = 0; c < CASES; c++) {
        struct pp_net net;
        struct pp_world *world = opened(&net, c);
        int folds = 0;
        for (int n = 0; n < net.panels.edge_numbers; n++) {
            int tabs = 0, plain = 0, folded = 0, taped = 0;
            for (int p = 0; p < net.panels.count; p++)
                for (int k = 0; k < net.panels.list[p].count; k++) {
                    const struct pp_net_edge *edge = &net.panels.list[p].edges[k];
                    if (edge->number != n)
                        continue;
                    tabs += edge->join == PP_NET_TAB;
                    plain += edge->join == PP_NET_PLAIN;
                    taped += edge->join == PP_NET_TAPE;
                    folded += edge->join == PP_NET_FOLD;
                    if (edge->join != PP_NET_FOLD)
                        continue;
                    double a[2], b[2];
                    pp_net_panels_corner(&net.panels.list[p], k, a);
                    pp_net_panels_corner(&net.panels.list[edge->panel], edge->edge + 1,
                                         b);
                    assert_near(hypot(a[0] - b[0], a[1] - b[1]), 0.0, 1e-6);
                }
            assert_true(folded + tabs + taped > 0);
            assert_true(folded % 2 == 0);
            assert_true(!plain || tabs);
            folds += folded;
        }
        /* A tree: each panel of a piece except the first is attached by one fold. */
        assert_int_equal(folds / 2, net.panels.count - net.piece_count);
        pp_net_unfold_clear(&net);
        pp_world_destroy(world);
    }
}

static void no_panel_lies_on_another(void **state)
{
    (void)state;
    struct pp_clipper *clipper;
    assert_int_equal(pp_clipper_create(&clipper, NULL), PP_OK);
    for (int c = 0; c < CASES; c++) {
        struct pp_net net;
        struct pp_world *world = opened(&net, c);
        for (int piece = 0; piece < net.piece_count; piece++) {
            struct pp_region parts[64] = {0}, all = {0};
            double sum = 0.0;
            int count = 0;
            for (int p = 0; p < net.panels.count; p++) {
                const struct pp_net_panel *panel = &net.panels.list[p];
                double xy[16][2];
                if (panel->piece != piece)
                    continue;
                for (int i = 0; i < panel->count; i++)
                    pp_net_panels_corner(panel, i, xy[i]);
                assert_int_equal(pp_clipper_of_ring(clipper, &parts[count++],
                                                    (const double(*)[2])xy,
                                                    panel->count, NULL),
                                 PP_OK);
                sum += area_of(panel);
            }
            assert_int_equal(pp_clipper_union(clipper, &all, parts, count, NULL),
                             PP_OK);
            assert_near(pp_region_area(&all), sum, 0.1);
            pp_region_clear(&all);
            for (int i = 0; i < count; i++)
                pp_region_clear(&parts[i]);
        }
        pp_net_unfold_clear(&net);
        pp_world_destroy(world);
    }
    pp_clipper_destroy(clipper);
}

/* True if a stroke has this length; a dashed line is one stroke in an SVG. */
static bool has_length(const struct strokes *strokes, double length)
{
    for (int i = 0; i < strokes->count; i++) {
        const struct stroke *s = &strokes->list[i];
        if (fabs(hypot(s->x1 - s->x0, s->y1 - s->y0) - length) < PAPER_MM)
            return true;
    }
    return false;
}

static void assert_drawn(const struct strokes *strokes,
                         const struct pp_polygon *outline, double mm)
{
    for (int i = 0; i < outline->count; i++) {
        struct pp_vec3 v = pp_vec_sub(outline->vertices[(i + 1) % outline->count],
                                      outline->vertices[i]);
        if (!has_length(strokes, mm * pp_vec_length(v)))
            fail_msg("no edge of %.3f mm is drawn", mm * pp_vec_length(v));
    }
}

/* Draws a net and reads its strokes; the caller frees them. */
static struct strokes drawn(const struct pp_world *world, double scale,
                            enum pp_paper paper)
{
    const struct pp_model_net model = {
        .world = world, .scale = scale, .box = {0.85, 0.5}};
    const struct pp_sheet on = {.format = PP_CHART_SVG, .paper = paper};
    struct pp_canvas *canvas;
    struct pp_error err = {0};
    const unsigned char *bytes;
    size_t length;
    assert_int_equal(pp_canvas_create(&canvas, &on, NULL), PP_OK);
    if (pp_net_chart_draw(canvas, &model, &err) != PP_OK)
        fail_msg("%s", err.message);
    assert_int_equal(pp_canvas_finish(canvas, &bytes, &length, NULL), PP_OK);
    char *svg = strndup((const char *)bytes, length);
    struct strokes strokes = strokes_of(svg);
    free(svg);
    pp_canvas_destroy(canvas);
    return strokes;
}

/* A door has only its sides and its head drawn, since its lower edge is that of the wall.
 * A dado has only its upper edges beside the door drawn, which end at the corners of the
 * wall and at the door. */
static void doors_and_dados_are_drawn_to_scale_without_the_edges_of_their_wall(
    void **state)
{
    (void)state;
    struct pp_outside_light light;
    struct pp_world *world = pp_test_lit_world(&light, covered);
    struct strokes strokes = drawn(world, 60.0, PP_PAPER_A3);
    double mm = 1000.0 / 60.0;
    assert_true(has_length(&strokes, mm * 2.03));
    assert_true(has_length(&strokes, mm * 0.97));
    assert_true(has_length(&strokes, mm * 2.2));
    assert_true(has_length(&strokes, mm * (4.23 - 2.2 - 0.97)));
    int heads = 0, sides = 0;
    for (int i = 0; i < strokes.count; i++) {
        const struct stroke *s = &strokes.list[i];
        double length = hypot(s->x1 - s->x0, s->y1 - s->y0);
        heads += fabs(length - mm * 0.97) < PAPER_MM;
        sides += fabs(length - mm * 2.03) < PAPER_MM;
    }
    assert_int_equal(heads, 1);
    assert_int_equal(sides, 2);
    free(strokes.list);
    pp_world_destroy(world);
}

static void every_edge_and_opening_is_drawn_to_scale(void **state)
{
    (void)state;
    static const char *const rooms[] = {box, bent, lean_to};
    static const double scales[] = {60.0, 40.0};
    static const enum pp_paper papers[] = {PP_PAPER_A3, PP_PAPER_A2};
    for (int r = 0; r < 3; r++)
        for (int n = 0; n < 2; n++) {
            struct pp_outside_light light;
            struct pp_world *world = pp_test_lit_world(&light, rooms[r]);
            double scale = scales[n] * (r == 1 ? 1.6 : 1.0);
            struct strokes strokes = drawn(world, scale, papers[n]);
            for (int i = 0; i < world->face_count; i++)
                assert_drawn(&strokes, &world->surfaces[i].outline, 1000.0 / scale);
            for (int i = 0; i < world->opening_count; i++)
                assert_drawn(&strokes, &world->openings[i].inner, 1000.0 / scale);
            free(strokes.list);
            pp_world_destroy(world);
        }
}

TEST_FILE
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(panels_are_their_faces_to_scale_seen_from_inside),
        cmocka_unit_test(pieces_are_as_many_as_they_must_and_lie_within_their_sheets),
        cmocka_unit_test(every_edge_is_folded_glued_or_taped),
        cmocka_unit_test(no_panel_lies_on_another),
        cmocka_unit_test(every_edge_and_opening_is_drawn_to_scale),
        cmocka_unit_test(
            doors_and_dados_are_drawn_to_scale_without_the_edges_of_their_wall),
    };
    add_tests(tests, NULL, NULL);
}
