/* test_print.c - a report printed as JSON, CSV and text: all contain the same numbers,
 * in per cent. */
#include "tests/lib/near.h"

#include <json.h>
#include <stdio.h>
#include <stdlib.h>

#include "reports/df_csv.h"
#include "reports/df_json.h"
#include "reports/df_text.h"

enum { POINTS = 3 };

/* A room with one window, with unusual names and numbers; the values of the methods are
 * made up. */
struct fixture {
    struct pp_vec3 floor[4], window_wall[4], window[4];
    struct pp_surface surfaces[2];
    struct pp_opening opening;
    struct pp_world world;
    struct pp_receiver receivers[POINTS];
    struct pp_study_options options;
    struct pp_result result;
    struct pp_results results;
    struct pp_error err;
};

static char awkward_name[] = "Caf\xc3\xa9 \"Nord\", \x1b[31m\nroom";

static void add_column(struct pp_report *report, enum pp_component component,
                       const char *name, const double *values, double average,
                       double std_error)
{
    struct pp_column *column = pp_report_add(report, component, name, values != NULL);
    assert_non_null(column);
    column->average = (struct pp_reading){average, std_error, NULL, NULL};
    for (int i = 0; values && i < report->receiver_count; i++)
        column->points[i] = (struct pp_reading){values[i], std_error, NULL, NULL};
}

static int set_up(void **state)
{
    struct fixture *f = calloc(1, sizeof *f);
    assert_non_null(f);
    const struct pp_vec3 floor[4] = {{0, 0, 0}, {3, 0, 0}, {3, 9, 0}, {0, 9, 0}};
    const struct pp_vec3 wall[4] = {{0, 0, 0}, {0, 0, 2.7}, {3, 0, 2.7}, {3, 0, 0}};
    const struct pp_vec3 window[4] = {
        {0.2, 0, 0.8}, {0.2, 0, 2.3}, {2.8, 0, 2.3}, {2.8, 0, 0.8}};
    memcpy(f->floor, floor, sizeof floor);
    memcpy(f->window_wall, wall, sizeof wall);
    memcpy(f->window, window, sizeof window);
    f->surfaces[0] = (struct pp_surface){
        .outline = {4, f->floor, {0, 0, 1}, 27.0}, .role = PP_FLOOR, .front = 0.2};
    f->surfaces[1] = (struct pp_surface){.outline = {4, f->window_wall, {0, 1, 0}, 8.1},
                                         .role = PP_WALL,
                                         .name = "south",
                                         .front = 0.5};
    f->opening = (struct pp_opening){.face = 1,
                                     .inner = {4, f->window, {0, 1, 0}, 3.9},
                                     .slope_rad = PP_PI / 2,
                                     .width_m = 2.6,
                                     .height_m = 1.5,
                                     .rectangle = true,
                                     .glass = pp_glass_clear_single(),
                                     .frame_factor = 1.0,
                                     .maintenance = 0.9,
                                     .curtains = 1.0};
    f->world = (struct pp_world){.name = awkward_name,
                                 .decorations = 1.0,
                                 .surfaces = f->surfaces,
                                 .surface_count = 2,
                                 .face_count = 2,
                                 .openings = &f->opening,
                                 .opening_count = 1,
                                 .height_m = 2.7,
                                 .working_plane_m = 0.85};
    for (int i = 0; i < POINTS; i++)
        f->receivers[i] = (struct pp_receiver){.position = {1.5, 0.5 + 3.7 * i, 0.85},
                                               .normal = {0, 0, 1}};

    struct pp_report *report = &f->result.report;
    *report = (struct pp_report){
        .world = &f->world,
        .light = {.sky = pp_sky_overcast(), .ground_reflectance = 0.2},
        .receivers = f->receivers,
        .receiver_count = POINTS,
        .finished = true};
    const double sky[POINTS] = {0.1 + 0.2, 0.0123456789012, 0.0};
    const double whole[POINTS] = {0.31, 0.0223456789012, 0.0101};
    const double traced[POINTS] = {0.3, 0.02, 0.01};
    add_column(report, PP_SC, "exact", sky, 0.03, NAN);
    add_column(report, PP_SC, "brs-table", sky, 0.03, NAN);
    add_column(report, PP_DF, "exact+bre", whole, 0.04, NAN);
    add_column(report, PP_DF, "average-df", NULL, 0.05, NAN);
    add_column(report, PP_DF, "traced", traced, 0.039, 0.00021);
    report->columns[1].points[1] =
        pp_reading_none("window W2 slopes; the \"table\" holds none");

    f->result.file = "a room, really.xml";
    f->options = PP_STUDY_OPTIONS_NONE;
    f->options.simulate = true;
    f->results =
        (struct pp_results){.list = &f->result, .count = 1, .options = &f->options};
    *state = f;
    return 0;
}

static int tear_down(void **state)
{
    struct fixture *f = *state;
    pp_report_clear(&f->result.report);
    free(f);
    return 0;
}

typedef enum pp_status printer(const struct pp_results *, FILE *, struct pp_error *);

static enum pp_status as_text(const struct pp_results *results, FILE *out,
                              struct pp_error *err)
{
    return pp_df_text(results, 80, true, out, err);
}

/* Text printed by a printer; the caller frees it. */
static char *printed(struct fixture *f, printer *print)
{
    char *text;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    assert_non_null(out);
    assert_int_equal(print(&f->results, out, &f->err), PP_OK);
    assert_int_equal(fclose(out), 0);
    for (const char *c = text; (c = strstr(c, "nan")) != NULL; c++)
        assert_true(c > text && c[-1] == 'e'); /* maintenance */
    assert_null(strstr(text, "inf"));
    return text;
}

/* The object at a path of keys; digits are indices into an array. */
static struct json_object *at(struct json_object *object, const char *path)
{
    char copy[128];
    snprintf(copy, sizeof copy, "%s", path);
    for (char *rest = copy, *key; (key = strsep(&rest, "/")) != NULL;) {
        if (json_object_is_type(object, json_type_array))
            object = json_object_array_get_idx(object, (size_t)atoi(key));
        else if (!json_object_object_get_ex(object, key, &object))
            fail_msg("there is no %s in %s", key, path);
    }
    return object;
}

static struct json_object *parsed(const char *text)
{
    struct json_object *object = json_tokener_parse(text);
    assert_non_null(object);
    return object;
}

static void json_holds_per_cent_under_the_names_of_the_contract(void **state)
{
    struct fixture *f = *state;
    char *text = printed(f, pp_df_json);
    struct json_object *room = parsed(text);
    assert_string_equal(json_object_get_string(at(room, "format")), "pepperpot-df-1");
    assert_string_equal(json_object_get_string(at(room, "sky")), "overcast");
    assert_string_equal(json_object_get_string(at(room, "room")), awkward_name);
    assert_int_equal(json_object_array_length(at(room, "points")), POINTS);
    /* Ten digits: half a unit of the last one. */
    assert_relative(json_object_get_double(at(room, "points/0/sc/exact/value")), 30.0,
                    0.0);
    assert_relative(json_object_get_double(at(room, "points/1/df/exact+bre/value")),
                    2.23456789012, 5e-10);
    assert_relative(json_object_get_double(at(room, "points/2/y")), 7.9, 0.0);
    assert_relative(json_object_get_double(at(room, "points/2/df/traced/se")), 0.021,
                    0.0);
    assert_relative(json_object_get_double(at(room, "average/df/average-df/value")),
                    5.0, 0.0);
    json_object_put(room);
    free(text);
}

static void json_gives_a_reason_for_a_missing_value(void **state)
{
    struct fixture *f = *state;
    char *text = printed(f, pp_df_json);
    struct json_object *room = parsed(text);
    struct json_object *entry = at(room, "points/1/sc/brs-table");
    assert_null(at(entry, "value"));
    assert_string_equal(json_object_get_string(at(entry, "why")),
                        "window W2 slopes; the \"table\" holds none");
    assert_false(json_object_object_get_ex(entry, "se", NULL));
    json_object_put(room);
    free(text);
}

static void json_reports_only_an_interrupted_run_as_unfinished(void **state)
{
    struct fixture *f = *state;
    char *text = printed(f, pp_df_json);
    assert_null(strstr(text, "finished"));
    free(text);
    f->result.report.finished = false;
    text = printed(f, pp_df_json);
    struct json_object *room = parsed(text);
    assert_true(json_object_is_type(at(room, "finished"), json_type_boolean));
    assert_false(json_object_get_boolean(at(room, "finished")));
    json_object_put(room);
    free(text);
}

static void json_of_a_building_is_an_array_even_of_one(void **state)
{
    struct fixture *f = *state;
    f->results.several = true;
    char *text = printed(f, pp_df_json);
    struct json_object *rooms = parsed(text);
    assert_true(json_object_is_type(rooms, json_type_array));
    assert_int_equal(json_object_array_length(rooms), 1);
    json_object_put(rooms);
    free(text);
}

static void json_of_bytes_that_are_no_text_is_still_json(void **state)
{
    struct fixture *f = *state;
    static char broken[] = "a\xff\xc0\xaf\xed\xa0\x80z\\\x01";
    f->world.name = broken;
    char *text = printed(f, pp_df_json);
    struct json_tokener *tokener = json_tokener_new();
    json_tokener_set_flags(tokener, JSON_TOKENER_STRICT | JSON_TOKENER_VALIDATE_UTF8);
    struct json_object *room = json_tokener_parse_ex(tokener, text, (int)strlen(text));
    assert_int_equal(json_tokener_get_error(tokener), json_tokener_success);
    json_object_put(room);
    json_tokener_free(tokener);
    free(text);
}

/* Parses one record of a CSV file; its unquoted fields go to `fields`. Returns the
 * position after it. */
static const char *next_record(const char *text, char fields[20][256], int *count)
{
    *count = 0;
    for (;;) {
        char *field = fields[(*count)++];
        bool quoted = *text == '"';
        text += quoted;
        while (quoted ? *text != '"' || text[1] == '"' : !strchr(",\r", *text)) {
            text += quoted && *text == '"';
            assert_true(*text != '\0');
            *field++ = *text++;
        }
        *field = '\0';
        text += quoted;
        if (*text != ',')
            break;
        text++;
    }
    assert_memory_equal(text, "\r\n", 2);
    return text + 2;
}

static void csv_has_one_record_a_value_and_reads_back(void **state)
{
    struct fixture *f = *state;
    char *text = printed(f, pp_df_csv);
    static char fields[20][256];
    int count, records = 0, whys = 0;
    const char *rest = next_record(text, fields, &count);
    assert_int_equal(count, 15);
    assert_string_equal(fields[1], "room");
    assert_string_equal(fields[11], "value_percent");
    for (; *rest; records++) {
        rest = next_record(rest, fields, &count);
        assert_int_equal(count, 15);
        assert_string_equal(fields[0], "a room, really.xml");
        assert_string_equal(fields[1], awkward_name);
        if (records == 0)
            assert_string_equal(fields[11], "30");
        whys += fields[14][0] != '\0';
        assert_true((fields[11][0] == '\0') == (fields[14][0] != '\0'));
    }
    /* Four columns have values for points, five for the room. */
    assert_int_equal(records, 4 * POINTS + 5);
    assert_int_equal(whys, 1);
    free(text);
}

static void text_keeps_to_the_width_and_to_visible_characters(void **state)
{
    struct fixture *f = *state;
    char *text = printed(f, as_text);
    assert_null(strchr(text, '\x1b'));
    int column = 0;
    for (const char *c = text; *c; c++) {
        if (((unsigned char)*c & 0xc0) != 0x80)
            column = *c == '\n' ? 0 : column + 1;
        assert_true(column <= 80);
    }
    free(text);
}

static void text_shows_the_traced_value_and_how_far_a_method_is_from_it(void **state)
{
    struct fixture *f = *state;
    char *text = printed(f, as_text);
    /* 0.31 is 3.3 % above 0.3; 0.021 % is rounded up to 0.03, so that an error is never
     * understated. */
    assert_non_null(strstr(text, "30.00 \xc2\xb1"
                                 "0.03"));
    assert_non_null(strstr(text, "+3.3"));
    assert_non_null(strstr(text, "brs-table: window W2 slopes"));
    free(text);
}

TEST_FILE
{
#define TEST(f) cmocka_unit_test_setup_teardown(f, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(json_holds_per_cent_under_the_names_of_the_contract),
        TEST(json_gives_a_reason_for_a_missing_value),
        TEST(json_reports_only_an_interrupted_run_as_unfinished),
        TEST(json_of_a_building_is_an_array_even_of_one),
        TEST(json_of_bytes_that_are_no_text_is_still_json),
        TEST(csv_has_one_record_a_value_and_reads_back),
        TEST(text_keeps_to_the_width_and_to_visible_characters),
        TEST(text_shows_the_traced_value_and_how_far_a_method_is_from_it),
    };
    add_tests(tests, NULL, NULL);
}
