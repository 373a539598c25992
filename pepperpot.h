/* pepperpot.h - public interface: daylight factors of rooms by hand methods and
 * simulation.
 *
 *     struct pp_mistakes *mistakes = pp_mistakes_create("room.xml");
 *     struct pp_building *building;
 *     struct pp_study *study;
 *     struct pp_error err;
 *
 *     if (pp_building_read(&building, "room.xml", mistakes, &err) == PP_OK
 *         && pp_study_create(&study, building, 0, NULL, mistakes, &err) == PP_OK
 *         && pp_study_methods(study, "exact+bre", false, &err) == PP_OK
 *         && pp_study_simulate(study, NULL, &err) == PP_OK)
 *         while (!pp_study_done(study))
 *             if (pp_study_advance(study, 0.1, &err) != PP_OK) ...
 *
 * Functions that can fail return a status, and fill err (which may be NULL) with a
 * message. No function prints or ends the process. Calls do not wait for other threads;
 * use each object in one thread at a time. Lengths are in metres. Daylight factors are
 * fractions of the unobstructed horizontal illuminance: 0.02, never 2. Each _create has
 * a _destroy, which accepts NULL; free returned memory with pp_free. The same input,
 * options and seed give identical figures, with any number of threads.
 */
#ifndef PEPPERPOT_H
#define PEPPERPOT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define PP_VERSION_MAJOR 0
#define PP_VERSION_MINOR 1
#define PP_VERSION_MICRO 0
#define PP_VERSION_NUMBER                                                              \
    (PP_VERSION_MAJOR * 10000 + PP_VERSION_MINOR * 100 + PP_VERSION_MICRO)

#ifdef __cplusplus
extern "C" {
#endif

/* ---- errors ---- */

enum pp_status {
    PP_OK = 0,
    PP_BAD_INPUT,   /* the input or its data is wrong */
    PP_SYSTEM,      /* system error: memory, disk, permission */
    PP_INTERRUPTED, /* stopped on request; the results so far are valid */
};

struct pp_error {
    enum pp_status status;
    char message[1024];
};

/* Version of the library at run time, as PP_VERSION_NUMBER; and as text, "0.1.0". */
int pp_version(void);
const char *pp_version_text(void);

/* Frees memory that a function of this header returned; NULL is allowed. */
void pp_free(void *bytes);

/* ---- room files ---- */

/* List of the errors in a file. file: name for messages, copied. Returns NULL if memory
 * is exhausted. */
struct pp_mistakes;
struct pp_mistakes *pp_mistakes_create(const char *file);
void pp_mistakes_destroy(struct pp_mistakes *mistakes);
int pp_mistakes_count(const struct pp_mistakes *mistakes);

/* Line of mistake `index`, from 1 (0: the file as a whole), and its message; valid
 * until the mistakes are destroyed. */
int pp_mistakes_line(const struct pp_mistakes *mistakes, int index);
const char *pp_mistakes_text(const struct pp_mistakes *mistakes, int index);

/* Contents of one file: one room, or a building of several rooms. */
struct pp_building;

/* Reads a room file; path "-" is standard input. Errors in the file are added to
 * mistakes (PP_BAD_INPUT). A missing file is PP_BAD_INPUT, an unreadable file
 * PP_SYSTEM. *building is also created for files with errors, as far as possible,
 * otherwise NULL. */
enum pp_status pp_building_read(struct pp_building **building, const char *path,
                                struct pp_mistakes *mistakes, struct pp_error *err);

/* Reads a room file from memory; otherwise like pp_building_read. */
enum pp_status pp_building_parse(struct pp_building **building, const char *bytes,
                                 size_t length, struct pp_mistakes *mistakes,
                                 struct pp_error *err);
void pp_building_destroy(struct pp_building *building);

const char *pp_building_name(
    const struct pp_building *building); /* NULL: a single room */
int pp_building_room_count(const struct pp_building *building);

/* ---- studies of a room ---- */

/* Components of the daylight factor: sky component, externally and internally reflected
 * component, and their sum. */
enum pp_component { PP_SC, PP_ERC, PP_IRC, PP_DF, PP_COMPONENT_COUNT };

struct pp_steps;

/* Result of one method, or of the simulation, for one component. */
struct pp_reading {
    double value;                 /* a fraction; NAN: no value, see why */
    double std_error;             /* standard error of value; NAN: not simulated */
    const char *why;              /* reason, not owned; NULL if there is a value */
    const struct pp_steps *steps; /* steps of the calculation, for
                                   * pp_study_report; NULL: none; not owned */
};

/* One room, its points, and its results. */
struct pp_study;

/* Creates a study of room `index` of a building; the building must exist as long as the
 * study. Errors in the room are added to mistakes (PP_BAD_INPUT, no study). The points
 * are those of the file, or a default grid. sky: type of sky as in a room file
 * ("uniform", "iso-12,40,180": with altitude and bearing of the sun in degrees); NULL:
 * the sky of the file. */
enum pp_status pp_study_create(struct pp_study **study, struct pp_building *building,
                               int index, const char *sky, struct pp_mistakes *mistakes,
                               struct pp_error *err);
void pp_study_destroy(struct pp_study *study);

/* Changes the sky, as above; NULL for the sky of the file. Deletes all results. Points
 * and the geometry of a simulation are kept. */
enum pp_status pp_study_set_sky(struct pp_study *study, const char *sky,
                                struct pp_error *err);

/* Name of the room; NULL if the file gives none. */
const char *pp_study_name(const struct pp_study *study);

/* Replaces the points by points that face up: x, y, z each; z NAN is the working plane.
 * Deletes all results. PP_BAD_INPUT if a point is not in the free space of the room. */
enum pp_status pp_study_set_points(struct pp_study *study, const double (*points)[3],
                                   int count, struct pp_error *err);

/* Replaces the points by the grid of `assess` over the working plane. Its spacing is
 * that of the grid in the file, otherwise 0.3 m, within the limits of EN 17037.
 * pp_study_judge then uses simulated daylight factors, if available. */
enum pp_status pp_study_set_grid(struct pp_study *study, struct pp_error *err);
int pp_study_point_count(const struct pp_study *study);
void pp_study_point(const struct pp_study *study, int index, double xyz[3]);

/* Calculates hand methods at the points and over the working plane. methods: names from
 * PP_LIST_METHODS separated by commas, pairs such as "exact+bre", "all", or NULL for
 * the default methods. explain: with the steps of the calculation, for a study of one
 * point. New columns are added to existing ones. */
enum pp_status pp_study_methods(struct pp_study *study, const char *methods,
                                bool explain, struct pp_error *err);

/* Sets a condition under which pp_study_methods and pp_study_plan stop with
 * PP_INTERRUPTED: for a program that may not need the result any more. `came` is called
 * often, from several threads at once; NULL: the functions are not stopped. */
void pp_study_stop_when(struct pp_study *study, bool (*came)(void *data), void *data);

/* Adds a variant of a published formula to all later calls of pp_study_methods: "irc =
 * 0.83 W / (A (1 - R)) (C R_fw + 5 R_cw)", or with the name of the method "split-flux:
 * irc = ...". Its columns are called "bre-variant", then "bre-variant-2". PP_BAD_INPUT
 * with the position of the error if the formula is invalid. */
enum pp_status pp_study_formula(struct pp_study *study, const char *formula,
                                struct pp_error *err);

/* Settings of a simulation. */
struct pp_simulation_request {
    const char *engine; /* from PP_LIST_ENGINES; NULL: "path" */
    double error; /* target for the relative standard error at every point; 0: 1 %,
                   * unless samples are given */
    long samples; /* instead of error: paths per point and randomisation; 0: unset */
    uint64_t seed;
    int threads; /* 0: one for each processor */
};

/* Default settings: "path", an error of 1 %, seed 1, all processors. */
struct pp_simulation_request pp_simulation_request_default(void);

/* Prepares a simulation of the points and of the average over the working plane; NULL:
 * default settings. A new simulation replaces the previous one; the columns of the
 * previous one are kept. */
enum pp_status pp_study_simulate(struct pp_study *study,
                                 const struct pp_simulation_request *request,
                                 struct pp_error *err);

/* Continues the simulation for about `seconds` of clock time. After each call the
 * columns ("traced" for engine "path", "cached" for "cache", "photons" for "photons")
 * contain the results so far. To stop, do not call the function again. */
enum pp_status pp_study_advance(struct pp_study *study, double seconds,
                                struct pp_error *err);
bool pp_study_done(const struct pp_study *study);

/* Estimated progress from 0 to 1, and the largest relative standard error of any point
 * (NAN before the first result). */
double pp_study_progress(const struct pp_study *study);
double pp_study_error(const struct pp_study *study);

/* Columns of results: one component by one method, pair or engine. */
int pp_study_column_count(const struct pp_study *study);
const char *pp_study_column_name(const struct pp_study *study, int column);
enum pp_component pp_study_column_component(const struct pp_study *study, int column);

/* Index of the column with this component and name ("exact+bre", "traced"), or -1. */
int pp_study_find(const struct pp_study *study, enum pp_component component,
                  const char *name);

/* Result at point `point`, or the average over the working plane for -1. */
struct pp_reading pp_study_reading(const struct pp_study *study, int column, int point);

/* ---- reports and charts ---- */

enum pp_format { PP_FORMAT_TEXT, PP_FORMAT_JSON, PP_FORMAT_CSV };

/* All results, in the form of `pepperpot df`. *bytes is UTF-8 with a terminating zero;
 * free it with pp_free. */
enum pp_status pp_study_report(const struct pp_study *study, enum pp_format format,
                               char **bytes, size_t *length, struct pp_error *err);

enum pp_chart_format { PP_CHART_PDF, PP_CHART_SVG, PP_CHART_PNG };
enum pp_paper { PP_PAPER_A4, PP_PAPER_A5, PP_PAPER_A3, PP_PAPER_A2 };
enum pp_orientation { PP_AS_FITS, PP_PORTRAIT, PP_LANDSCAPE };

struct pp_chart_request {
    enum pp_chart_format format;
    enum pp_paper paper;
    enum pp_orientation orientation;
    double dpi;          /* for PNG, 20 to 1200; 0: 200 */
    bool logarithmic;    /* section: scale of daylight factors */
    const char *methods; /* methods shown; NULL: the default methods */
};

/* Draws a chart at true scale into memory. kind: from PP_LIST_CHARTS. study NULL: a
 * blank sheet, for the diagrams of hand methods. Charts of a room show hand figures,
 * which are recalculated. request NULL: a PDF on A4. */
enum pp_status pp_study_chart(const struct pp_study *study, const char *kind,
                              const struct pp_chart_request *request, char **bytes,
                              size_t *length, struct pp_error *err);

/* Geometry of the resolved room for drawing, as a JSON object "pepperpot-scene-1":
 * surfaces, openings, blocks, skylines and gardens with their lines in the file, and
 * the points. The caller frees *bytes. */
enum pp_status pp_study_scene(const struct pp_study *study, char **bytes,
                              size_t *length, struct pp_error *err);

/* Contours of the daylight factor on the working plane and the no-sky line, as a JSON
 * object "pepperpot-plan-1" of polylines. methods: one direct method or pair that gives
 * a value at every point; NULL: the default pair. tolerance: greatest error of the
 * position of the lines, in metres; charts use 0.001. The caller frees *bytes. */
enum pp_status pp_study_plan(const struct pp_study *study, const char *methods,
                             double tolerance, char **bytes, size_t *length,
                             struct pp_error *err);

/* without: true if later calls of pp_study_plan leave out "average", the mean of the
 * plane, which is then null. With a tolerance of 0.1 m it takes up to half of the time,
 * which matters while a person drags a window. */
void pp_study_plan_without_average(struct pp_study *study, bool without);

/* ---- criteria and sizes ---- */

enum pp_verdict {
    PP_STATED, /* for information, without a target */
    PP_MET,
    PP_NOT_MET,
    PP_UNDECIDED, /* the error of the figure is too large */
    PP_NOT_JUDGED /* not applicable to this room; the note gives the reason */
};

/* One figure of a criterion. Texts belong to the study, and are valid until the next
 * pp_study_judge. The confidence takes only the noise of the simulation into account.
 * Unlike the command assess, the library does not test whether a larger building around
 * the room would change the verdict. */
struct pp_judgement {
    const char *criterion; /* from PP_LIST_CRITERIA */
    const char *what;      /* "W1, south" */
    double figure;         /* NAN: not applicable */
    double std_error;      /* standard error of figure; NAN: not simulated */
    double wanted;         /* target; NAN: none */
    bool at_most;          /* wanted is a maximum, otherwise a minimum */
    enum pp_verdict verdict;
    double confidence; /* probability that the verdict is correct; NAN: not simulated */
    const char *basis, *note; /* sentences; may be empty */
};

/* Assesses the room. criteria: names separated by commas, NULL for all.
 * median_diffuse_lux: median outdoor diffuse illuminance of the place, for EN 17037; 0:
 * from the site of the room. */
enum pp_status pp_study_judge(struct pp_study *study, const char *criteria,
                              double median_diffuse_lux, struct pp_error *err);
int pp_study_judgement_count(const struct pp_study *study);
struct pp_judgement pp_study_judgement(const struct pp_study *study, int index);

enum pp_size_change {
    PP_CHANGE_WIDTH,
    PP_CHANGE_HEIGHT, /* for a rooflight: its depth; the centre stays in place */
    PP_CHANGE_HEAD,
    PP_CHANGE_SILL,
    PP_CHANGE_NUMBER,
};

enum pp_size_verdict {
    PP_SIZE_REACHED,
    PP_SIZE_SMALLEST_EXCEEDS, /* even the smallest size exceeds the target */
    PP_SIZE_OUT_OF_REACH,     /* no size meets the target; result: the best size */
    PP_SIZE_NO_VALUE,         /* `why` gives the reason */
};

struct pp_size_found {
    enum pp_size_verdict verdict;
    double now, value; /* average of the present room; at the size found; NAN: none */
    char method[64];   /* method used */
    char why[512];     /* reason for no value; otherwise empty */
};

/* Finds the smallest windows with which the average daylight factor over the working
 * plane meets the target, a fraction, by a hand method or pair (NULL: one that covers
 * the room). *file (may be NULL): the changed room file, which the caller frees with
 * pp_free; NULL if the target is not met. */
enum pp_status pp_study_size(const struct pp_study *study, double target,
                             enum pp_size_change change, const char *method,
                             struct pp_size_found *found, char **file,
                             struct pp_error *err);

/* ---- available names ---- */

enum pp_list { PP_LIST_METHODS, PP_LIST_ENGINES, PP_LIST_CHARTS, PP_LIST_CRITERIA };

/* Name and summary (a line without a full stop) of entry `index`, from 0; NULL after
 * the last entry. */
const char *pp_list_name(enum pp_list list, int index);
const char *pp_list_summary(enum pp_list list, int index);

#ifdef __cplusplus
}
#endif

#endif
