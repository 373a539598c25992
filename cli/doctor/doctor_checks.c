/* doctor_checks.c - the checks, in the order in which they are printed. */
#include "config.h"

#include "cli/doctor/doctor_checks.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "charts/test_page.h"
#include "cli/output.h"
#include "cli/program/program_place.h"
#include "model/base/thread_pool.h"
#include "studies/research/validation/known_room.h"

/* ---- a known daylight factor ---- */

/* Sky component of an unglazed window 1 m wide and high, 1 m from the point, with one
 * lower corner opposite the point. Closed form for the overcast sky, w = h = 1:
 *
 *   3/(14 pi) (atan w - atan(w/r)/r)
 *     + 2/(7 pi) (asin(w h / sqrt((1 + w^2)(1 + h^2))) - w h / (r^2 sqrt(r^2 + w^2))),
 *   r^2 = 1 + h^2: 0.04525138
 */
static const double known_factor = 0.04525138;
static const char known_xml[] =
    "<room version='1'><plan width='4' depth='4' height='4'/>"
    "<window wall='south' left='1' sill='1' height='1' width='1' glazing='none'/>"
    "<working-plane height='1'/><point x='1' y='1'/></room>";

static void check_by_hand(struct pp_doctor_check *check)
{
    struct pp_known_room room;
    struct pp_error err;
    if (pp_known_room_evaluate(&room, known_xml, "exact", &err) != PP_OK) {
        snprintf(check->result, sizeof check->result, "%.500s", err.message);
        return;
    }
    double found = pp_known_room_at_point(&room, PP_SC, "exact");
    pp_known_room_clear(&room);
    check->passes = fabs(found - known_factor) < 1e-6;
    snprintf(check->result, sizeof check->result,
             "daylight factor %.4f %%, known value %.4f %%", 100.0 * found,
             100.0 * known_factor);
}

/* Checks that the simulated value is within four standard errors. By chance, 1 seed in
 * 16,000 would fail; the seed is fixed. */
static void check_simulated(struct pp_doctor_check *check)
{
    const struct pp_known_trace how = {.seed = 1, .samples = 512};
    struct pp_reading readings[1][PP_COMPONENT_COUNT] = {0};
    struct pp_outside_light light;
    struct pp_world *world;
    struct pp_error err;
    enum pp_status status = pp_known_room_world(&world, &light, known_xml, &err);
    if (status == PP_OK)
        status = pp_known_room_trace(readings, world, &light, world->receivers, 1, &how,
                                     &err);
    pp_world_destroy(world);
    if (status != PP_OK) {
        snprintf(check->result, sizeof check->result, "%.500s", err.message);
        return;
    }
    struct pp_reading found = readings[0][PP_SC];
    check->passes = fabs(found.value - known_factor) < 4.0 * found.std_error + 1e-8;
    snprintf(check->result, sizeof check->result,
             "daylight factor %.4f %% ± %.4f %%, known value %.4f %%",
             100.0 * found.value, 100.0 * found.std_error, 100.0 * known_factor);
}

/* ---- threads ---- */

enum { TASKS = 1000 };

static bool count_task(void *data, int worker, int index)
{
    (void)worker;
    ((unsigned char *)data)[index]++;
    return true;
}

static void check_threads(struct pp_doctor_check *check)
{
    struct pp_thread_pool *pool;
    struct pp_error err;
    unsigned char done[TASKS] = {0};
    if (pp_thread_pool_create(&pool, 0, &err) != PP_OK) {
        snprintf(check->result, sizeof check->result, "%.500s", err.message);
        return;
    }
    int size = pp_thread_pool_size(pool);
    check->passes = pp_thread_pool_run(pool, 0, TASKS, count_task, done) == TASKS;
    for (int i = 0; i < TASKS; i++)
        check->passes = check->passes && done[i] == 1;
    pp_thread_pool_destroy(pool);
    snprintf(check->result, sizeof check->result, "%d, one for each processor", size);
}

/* ---- drawings ---- */

enum pp_status pp_doctor_checks_page(struct pp_canvas **canvas,
                                     const unsigned char **bytes, size_t *length,
                                     enum pp_chart_format format, struct pp_error *err)
{
    const struct pp_sheet sheet = {
        .format = format,
        .paper = PP_PAPER_A4,
        .title = "Test page",
        .description = "Rulers, greys, line widths, hatches and text at true scale"};
    enum pp_status status = pp_canvas_create(canvas, &sheet, err);
    if (status == PP_OK) {
        pp_canvas_set_imprint(*canvas, PACKAGE_NAME " " PACKAGE_VERSION);
        status = pp_test_page_draw(*canvas, err);
    }
    return status == PP_OK ? pp_canvas_finish(*canvas, bytes, length, err) : status;
}

static void check_format(struct pp_doctor_check *check, enum pp_chart_format format,
                         const char *beginning)
{
    struct pp_canvas *canvas = NULL;
    const unsigned char *bytes;
    size_t length;
    struct pp_error err;
    if (pp_doctor_checks_page(&canvas, &bytes, &length, format, &err) != PP_OK) {
        snprintf(check->result, sizeof check->result, "%.500s", err.message);
    } else {
        size_t first = strlen(beginning);
        check->passes = length > first && memcmp(bytes, beginning, first) == 0;
        snprintf(check->result, sizeof check->result, "%s of %zu bytes",
                 check->passes ? "a test page" : "not a file of that format,", length);
    }
    pp_canvas_destroy(canvas);
}

static void check_font(struct pp_doctor_check *check)
{
    char family[128];
    int missing = pp_test_page_font(family, sizeof family);
    check->passes = family[0] != '\0' && missing == 0;
    if (!family[0])
        snprintf(check->result, sizeof check->result,
                 "none found; install a font, for example DejaVu Sans");
    else if (missing)
        snprintf(check->result, sizeof check->result,
                 "%s; this font lacks %d characters of the test page", family, missing);
    else
        snprintf(check->result, sizeof check->result, "%s", family);
}

/* ---- files ---- */

static bool reads_back(const char *path, const char *text)
{
    char read[64] = "";
    FILE *in = fopen(path, "rb");
    if (!in)
        return false;
    size_t length = fread(read, 1, sizeof read - 1, in);
    bool good = length == strlen(text) && memcmp(read, text, length) == 0;
    fclose(in);
    return good;
}

/* Writes a file in TMPDIR like an output file, reads it and removes it. */
static void check_writing(struct pp_doctor_check *check)
{
    static const char text[] = "pepperpot doctor\n";
    const char *place = pp_program_place_temporary();
    char path[PATH_MAX];
    struct pp_output output;
    struct pp_error err = {.message = "the bytes read back differ from those written"};
    snprintf(path, sizeof path, "%s/pepperpot-doctor-%ld", place, (long)getpid());
    enum pp_status status = pp_output_open(&output, path, &err);
    if (status == PP_OK) {
        fputs(text, output.stream);
        status = pp_output_commit(&output, &err);
    }
    check->passes = status == PP_OK && reads_back(path, text);
    if (status == PP_OK)
        unlink(path);
    if (check->passes)
        snprintf(check->result, sizeof check->result,
                 "a file was written and read back in %s", place);
    else
        snprintf(check->result, sizeof check->result, "%.500s", err.message);
}

void pp_doctor_checks_run(struct pp_doctor_check list[PP_DOCTOR_CHECK_COUNT])
{
    static const char *const names[PP_DOCTOR_CHECK_COUNT] = {
        "by hand", "simulated", "threads", "PDF", "SVG", "PNG", "font", "files"};
    for (int i = 0; i < PP_DOCTOR_CHECK_COUNT; i++)
        list[i] = (struct pp_doctor_check){.name = names[i]};
    check_by_hand(&list[0]);
    check_simulated(&list[1]);
    check_threads(&list[2]);
    check_format(&list[3], PP_CHART_PDF, "%PDF-");
    check_format(&list[4], PP_CHART_SVG, "<?xml");
    check_format(&list[5], PP_CHART_PNG, "\x89PNG\r\n");
    check_font(&list[6]);
    check_writing(&list[7]);
}
