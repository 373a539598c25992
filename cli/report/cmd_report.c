/* cmd_report.c - the command report: drawings, results and verdicts of rooms, as one
 * HTML page or as a PDF. */
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "config.h"
#include "api/cited_works.h"
#include "cli/assess/assess_run.h"
#include "cli/command.h"
#include "cli/document_pdf.h"
#include "cli/message.h"
#include "cli/output.h"
#include "cli/report/report_pictures.h"
#include "model/base/text.h"
#include "reports/page/document_html.h"
#include "reports/page/site_report.h"

/* A report of at most this many rooms has all sections even without --full. */
enum { SHORT_ROOMS = 2 };

#define PLACE(member) offsetof(struct pp_assess_words, member)

static const char about[] =
    "Writes a report of all rooms in a file: one self-contained HTML page with -o "
    "FILE.html, or A4 sheets with -o FILE.pdf. For each room it shows daylight "
    "factors by hand with their bands, simulated ones with standard errors, and the "
    "criteria. It adds the effect of changes, a plan and a section, and states how "
    "the figures were calculated. For a site it shows plan and elevations, the sky "
    "seen from every window and the lit area of every room. Existing and proposed "
    "states are compared. If sunlight is assessed, it adds sun paths. FILE is a "
    "room file; - is standard input.";

static enum pp_status read_format(const char *text, void *place, struct pp_error *err)
{
    if (strcmp(text, "html") != 0 && strcmp(text, "pdf") != 0)
        return pp_fail(err, PP_BAD_INPUT, "html or pdf");
    *(const char **)place = text;
    return PP_OK;
}

static const struct pp_option format_option[] = {
    {"format", 'f', "FORMAT",
     "html or pdf (default: from the extension of -o FILE, else html).", read_format,
     PLACE(report_format)},
    {0},
};

static const struct pp_option number_option[] = {
    {"number", 0, "TEXT", "Project number.", pp_options_read_text,
     PLACE(project.number)},
    {0},
};

static const struct pp_option full_option[] = {
    {"full", 0, NULL,
     "Show the data, averages, criteria, effect of changes, plan and section of each "
     "room. Without this option, a report of more than two rooms has one table for "
     "each "
     "criterion, with a row for each room.",
     NULL, PLACE(full)},
    {"year", 0, NULL,
     "With --weather: also simulate every hour of the year, and show sDA, ASE, "
     "daylight autonomy and a map of the hours, with blinds as in LM-83-12.",
     NULL, PLACE(with_year)},
    {0},
};

/* Extension of the file name, from its last dot; NULL: none. */
static const char *extension_of(const char *path)
{
    const char *slash = path ? strrchr(path, '/') : NULL;
    const char *name = slash ? slash + 1 : path;
    return name ? strrchr(name, '.') : NULL;
}

/* True if the report is a PDF, according to --format or, without --format, to the
 * extension of its name. */
static bool is_pdf(const struct pp_assess_words *words)
{
    const char *extension = extension_of(words->room.output);
    return words->report_format ? strcmp(words->report_format, "pdf") == 0
                                : extension && strcasecmp(extension, ".pdf") == 0;
}

/* ---- the command line that reproduces the report ---- */

static bool is_safe(const char *word)
{
    return *word
           && word[strspn(word, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                "0123456789_+-./,:%@=")]
                  == '\0';
}

/* Prints a space and the word, in quotes if the shell requires them. */
static void put_word(const char *word, FILE *out)
{
    fputc(' ', out);
    if (is_safe(word)) {
        fputs(word, out);
        return;
    }
    fputc('\'', out);
    for (; *word; word++)
        fputs(*word == '\'' ? "'\\''" : (const char[]){*word, '\0'}, out);
    fputc('\'', out);
}

/* Prints an option and its value `word`; prints nothing if `word` is NULL. */
static void put_option(const char *option, const char *word, FILE *out)
{
    if (!word)
        return;
    fprintf(out, " %s", option);
    put_word(word, out);
}

static void put_cut(const struct pp_section_place *cut, FILE *out)
{
    if (cut->kind == PP_SECTION_THROUGH)
        put_option("--cut", cut->opening, out);
    else if (cut->kind != PP_SECTION_OF_ROOM)
        fprintf(out, " --cut %s=%.10g", cut->kind == PP_SECTION_AT_X ? "x" : "y",
                cut->at_m);
}

static void put_grid(const struct pp_grid_choice *grid, FILE *out)
{
    if (grid->largest)
        fputs(" --spacing largest", out);
    else if (grid->spacing_m > 0.0)
        fprintf(out, " --spacing %.10g,%.10g", grid->spacing_m, grid->margin_m);
}

static void put_choice(const struct pp_assess_words *words, FILE *out)
{
    static const char *const states[] = {[PP_STATE_BOTH] = NULL,
                                         [PP_STATE_EXISTING] = "existing",
                                         [PP_STATE_PROPOSED] = "proposed",
                                         [PP_STATE_CUMULATIVE] = "cumulative"};
    put_option("--criteria", words->criteria, out);
    put_option("--for", words->profile_name, out);
    if (words->withdrawn)
        fputs(" --withdrawn", out);
    put_option("--before", words->before, out);
    if (words->mirror_image.given)
        fprintf(out, " --mirror-image %.10g,%.10g,%.10g,%.10g",
                words->mirror_image.line.from[0], words->mirror_image.line.from[1],
                words->mirror_image.line.to[0], words->mirror_image.line.to[1]);
    put_option("--place", words->place, out);
    if (words->median_lux > 0.0 && !words->weather)
        fprintf(out, " --median-diffuse %.10g", words->median_lux);
    put_option("--weather", words->weather, out);
    if (words->least_altitude_rad > 0.0)
        fprintf(out, " --least-altitude %.10g", words->least_altitude_rad / PP_RAD);
    if (words->shortest_h > 0.0)
        fprintf(out, " --shortest %.10g", 60.0 * words->shortest_h);
    put_grid(&words->grid, out);
    if (words->with_year)
        fputs(" --year", out);
    if (words->french_m > 0.0)
        fprintf(out, " --vsc-point-french %.10g", words->french_m);
    put_cut(&words->cut, out);
    for (int i = 0; i < PP_PROJECT_FACTS; i++) {
        char option[24];
        snprintf(option, sizeof option, "--%s",
                 i == 0 ? "project" : pp_project_facts[i].name);
        put_option(option, pp_project_at(&words->project, i), out);
    }
    if (words->full)
        fputs(" --full", out);
    put_option("--format", words->report_format, out);
    put_option("--room", words->room.room, out);
    put_option("--state", states[words->room.state], out);
}

static void put_simulation(const struct pp_study_options *study, FILE *out)
{
    if (!study->simulate) {
        fputs(" --by-hand", out);
        return;
    }
    if (study->samples > 0)
        fprintf(out, " --samples %ld", study->samples);
    if (study->error > 0.0)
        fprintf(out, " --error %.10g%%", 100.0 * study->error);
    if (study->seconds > 0.0)
        fprintf(out, " --time %.10gs", study->seconds);
    fprintf(out, " --seed %llu", (unsigned long long)study->seed);
}

/* Makes the command line with options for criteria, files, rooms and simulation, quoted
 * for a shell. The caller frees the text. NULL: out of memory. */
static char *made_words(const struct pp_assess_run *run)
{
    char *text = NULL;
    size_t length;
    FILE *out = open_memstream(&text, &length);
    if (!out)
        return NULL;
    fputs("pepperpot report", out);
    put_choice(run->words, out);
    put_simulation(&run->words->room.study, out);
    const char *last = "";
    for (int i = 0; i < run->rooms->count; i++) {
        if (strcmp(run->rooms->list[i].file, last) != 0)
            put_word(run->rooms->list[i].file, out);
        last = run->rooms->list[i].file;
    }
    return fclose(out) == 0 ? text : NULL;
}

/* ---- the report ---- */

/* True if the report has all sections for every room. */
static bool is_full(const struct pp_assess_run *run)
{
    return run->words->full || run->rooms->count <= SHORT_ROOMS;
}

static enum pp_status print_html(const struct pp_document *document, const char *title,
                                 const struct pp_report_pictures *pictures, FILE *out,
                                 struct pp_error *err)
{
    struct pp_svg_picture *svgs = calloc((size_t)pictures->count + 1, sizeof *svgs);
    if (!svgs)
        return pp_fail_memory(err);
    enum pp_status status = PP_OK;
    for (int i = 0; i < pictures->count && status == PP_OK; i++) {
        const unsigned char *bytes;
        status = pp_canvas_finish(pictures->canvases[i], &bytes, &svgs[i].length, err);
        svgs[i].bytes = (const char *)bytes;
    }
    if (status == PP_OK)
        pp_document_html(document, title, svgs, out);
    free(svgs);
    return status;
}

/* Text for the foot of sheets: title, project number, revision and date. */
static void write_foot(char foot[256], const char *title,
                       const struct pp_project *project)
{
    foot[0] = '\0';
    pp_text_append(foot, 256, "%.100s", title);
    if (project->number)
        pp_text_append(foot, 256, " · %.40s", project->number);
    if (project->revision)
        pp_text_append(foot, 256, " · revision %.40s", project->revision);
    if (project->date)
        pp_text_append(foot, 256, " · %.40s", project->date);
}

static enum pp_status print_site_report(const void *data, FILE *out,
                                        struct pp_error *err)
{
    const struct pp_assess_run *run = data;
    const char *title = pp_study_room_title(&run->rooms->list[0]);
    char *made_by = made_words(run);
    bool pdf = is_pdf(run->words);
    struct pp_report_pictures pictures;
    struct pp_document document = {0};
    if (!made_by)
        return pp_fail_memory(err);
    if (!is_full(run) && run->words->cut.kind != PP_SECTION_OF_ROOM)
        pp_message("--cut has no effect: a report of more than %d rooms has sections "
                   "only with --full",
                   SHORT_ROOMS);
    enum pp_status status =
        pp_report_pictures_draw(&pictures, run, is_full(run), pdf, err);
    struct pp_project project = *pp_building_project(run->rooms->list[0].building);
    for (int i = 0; i < PP_PROJECT_FACTS; i++)
        if (pp_project_at(&run->words->project, i))
            *pp_project_place(&project, i) = pp_project_at(&run->words->project, i);
    const struct pp_site_report report = {.all = &run->all,
                                          .project = &project,
                                          .full = is_full(run),
                                          .title = title,
                                          .made_by = made_by,
                                          .version = PACKAGE_VERSION,
                                          .pictures = pictures.list,
                                          .picture_count = pictures.count,
                                          .work_of = pp_cited_works_find};
    char foot[256];
    write_foot(foot, title, &project);
    if (status == PP_OK)
        status = pp_site_report(&document, &report, err);
    if (status == PP_OK && pdf)
        status = pp_document_pdf(&document, foot, "Daylight of rooms", false,
                                 pictures.canvases, out, err);
    else if (status == PP_OK)
        status = print_html(&document, title, &pictures, out, err);
    pp_document_clear(&document);
    pp_report_pictures_clear(&pictures);
    free(made_by);
    return status;
}

/* Checks the options. PP_BAD_INPUT if the extension of the name does not stand for a
 * known format, unless --format is given. */
static enum pp_status check_report_options(void *values, char **files, int file_count,
                                           struct pp_error *err)
{
    const struct pp_assess_words *words = values;
    const char *extension = extension_of(words->room.output);
    if (extension && !words->report_format && !is_pdf(words)
        && strcasecmp(extension, ".html") != 0 && strcasecmp(extension, ".htm") != 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "--output: expected a name that ends in .html or .pdf instead "
                       "of \"%.20s\", or --format html or pdf",
                       extension);
    return pp_assess_words_check(values, files, file_count, err);
}

static enum pp_exit run_report(void *values, char **files, int file_count)
{
    struct pp_assess_words *words = values;
    words->of_averages = true;
    words->gains_rooms = words->full ? 0 : SHORT_ROOMS;
    return pp_assess_run(words, "report", files, file_count, print_site_report);
}

static const struct pp_option_group groups[] = {
    {"Criteria", pp_assess_words_choice, 0},
    {"Criteria", pp_room_french_option, PLACE(french_m)},
    {"Criteria", pp_room_spacing_option, PLACE(grid)},
    PP_ROOM_BY_HAND_GROUPS(PLACE(room)),
    {"Title block", pp_room_project_options, PLACE(project)},
    {"Title block", number_option, 0},
    {"Output", pp_room_cut_option, PLACE(cut)},
    {"Output", full_option, 0},
    {"Output", format_option, 0},
    {"Output", pp_room_output_options, PLACE(room)},
    {0},
};

const struct pp_command pp_command_report = {
    .name = "report",
    .summary = "a complete report as HTML or PDF: drawings, figures, verdicts",
    .operands = "FILE...",
    .about = about,
    .groups = groups,
    .size = sizeof(struct pp_assess_words),
    .more_help = pp_assess_words_help,
    .init = pp_assess_words_init,
    .check = check_report_options,
    .run = run_report,
    .clear = pp_assess_words_clear,
    .uses_ranks = true,
    .ranks_place = PLACE(room.ranks),
};
