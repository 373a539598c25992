/* pepperpot.h - daylight factors of rooms, by hand and by ray: the public interface.
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
 * What can fail returns a status and fills err (which may be NULL) with a sentence for
 * people. Nothing is printed, nothing ends the process, and no call waits for another
 * thread's; one object belongs to one thread at a time. Lengths are in metres, daylight
 * factors fractions of the open sky's horizontal illuminance: 0.02, never 2. Whatever
 * is made is destroyed by its own _destroy, which takes NULL, too; bytes that a call
 * hands out are freed by pp_free. The same input, options and seed give the same
 * figures to the bit, on any number of threads.
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
    PP_SYSTEM,      /* the machine failed: memory, disk, permission */
    PP_INTERRUPTED, /* stopped on request; what there is so far is good */
};

struct pp_error {
    enum pp_status status;
    char message[1024];
};

/* The version of the library that runs, as PP_VERSION_NUMBER; and as text, "0.1.0". */
int pp_version(void);
const char *pp_version_text(void);

/* Frees bytes that a call of this header handed out; NULL is allowed. */
void pp_free(void *bytes);

/* ---- room files ---- */

/* All that is wrong with a file, by line. file: its name for people, copied. NULL when
 * memory is out. */
struct pp_mistakes;
struct pp_mistakes *pp_mistakes_create(const char *file);
void pp_mistakes_destroy(struct pp_mistakes *mistakes);
int pp_mistakes_count(const struct pp_mistakes *mistakes);

/* Line of mistake `index`, from 1 (0: of the file as a whole), and its text with the
 * expected value; good until the mistakes are destroyed. */
int pp_mistakes_line(const struct pp_mistakes *mistakes, int index);
const char *pp_mistakes_text(const struct pp_mistakes *mistakes, int index);

/* Contents of one file: one room, or a building of several. */
struct pp_building;

/* Reads a room file; path "-" is standard input. Whatever is wrong with the file's form
 * or values goes to mistakes (PP_BAD_INPUT); a file that can't be read at all is
 * PP_SYSTEM (or PP_BAD_INPUT where it does not exist). *building is made even when
 * there are mistakes, as far as the file could be understood; NULL where nothing could
 * be. */
enum pp_status pp_building_read(struct pp_building **building, const char *path,
                                struct pp_mistakes *mistakes, struct pp_error *err);

/* The same from memory. */
enum pp_status pp_building_parse(struct pp_building **building, const char *bytes,
                                 size_t length, struct pp_mistakes *mistakes,
                                 struct pp_error *err);
void pp_building_destroy(struct pp_building *building);

const char *pp_building_name(
    const struct pp_building *building); /* NULL: a lone room */
int pp_building_room_count(const struct pp_building *building);

/* ---- studies of a room ---- */

/* The parts of a daylight factor: sky component, externally and internally reflected
 * component, and their sum. */
enum pp_component { PP_SC, PP_ERC, PP_IRC, PP_DF, PP_COMPONENT_COUNT };

struct pp_steps;

/* Result of one method, or of the simulation, for one component. */
struct pp_reading {
    double value;     /* a fraction; NAN where there is none: see why */
    double std_error; /* of value; NAN where it was not sampled */
    const char *why;  /* one sentence, not owned; NULL where there is a value */
    const struct pp_steps *steps; /* the sum as on paper, for pp_study_report; NULL
                                   * unless asked for; not owned */
};

/* One room, its points, and what was found out about it. */
struct pp_study;

/* Study of room `index` of a building, which must live as long. What does not make sense
 * in the room goes to mistakes (PP_BAD_INPUT, no study). The points are the file's, or a
 * default grid. sky: a type as in a room file in place of the file's own ("uniform",
 * "iso-12,40,180": with the sun's altitude and bearing in degrees); NULL: the file's. */
enum pp_status pp_study_create(struct pp_study **study, struct pp_building *building,
                               int index, const char *sky, struct pp_mistakes *mistakes,
                               struct pp_error *err);
void pp_study_destroy(struct pp_study *study);

/* Another sky, as above, NULL for the file's. What was found out before is forgotten;
 * the points stay, and what a simulation has built of the room's geometry. */
enum pp_status pp_study_set_sky(struct pp_study *study, const char *sky,
                                struct pp_error *err);

/* The room's name; NULL where the file gives none. */
const char *pp_study_name(const struct pp_study *study);

/* Other points, facing up: x, y, z each; z NAN is the working plane. What was found out
 * before is forgotten. PP_BAD_INPUT where a point lies in no free space of the room. */
enum pp_status pp_study_set_points(struct pp_study *study, const double (*points)[3],
                                   int count, struct pp_error *err);

/* A grid over the working plane in place of the points: that of `assess`, with the spacing
 * of the file's grid, else 0.3 m, within the limits of EN 17037. pp_study_judge then judges
 * by simulated factors, if there are any. */
enum pp_status pp_study_set_grid(struct pp_study *study, struct pp_error *err);
int pp_study_point_count(const struct pp_study *study);
void pp_study_point(const struct pp_study *study, int index, double xyz[3]);

/* Works out hand methods at the points and over the working plane. methods: names with
 * commas between, pairs as "exact+bre", "all", or NULL for the default ones; the names
 * are those of PP_LIST_METHODS. explain: with the steps of their sums, of a study of one
 * point. Adds columns; those that are there stay. */
enum pp_status pp_study_methods(struct pp_study *study, const char *methods,
                                bool explain, struct pp_error *err);

/* Sets a variant of a method's published formula beside the original, in each
 * pp_study_methods from now on: "irc = 0.83 W / (A (1 - R)) (C R_fw + 5 R_cw)", or with
 * the method's name "split-flux: irc = ...". Its columns are called "bre-variant", the
 * next "bre-variant-2". PP_BAD_INPUT with the place where the text cannot be worked
 * out. */
enum pp_status pp_study_formula(struct pp_study *study, const char *formula,
                                struct pp_error *err);

/* Settings of a simulation, and when it is done. */
struct pp_simulation_request {
    const char *engine; /* of PP_LIST_ENGINES; NULL: "path" */
    double error; /* wanted standard error over daylight factor, at every point; 0: 1 %,
                   * unless samples are given */
    long samples; /* paths a point in each randomisation instead; 0: not given */
    uint64_t seed;
    int threads; /* 0: as many as there are processors */
};

/* "path", an error of 1 %, seed 1, all processors. */
struct pp_simulation_request pp_simulation_request_default(void);

/* Prepares a simulation of the points and of the average over the working plane; NULL is
 * the default request. One at a time: another one takes its place, while the columns of
 * the one before stay. */
enum pp_status pp_study_simulate(struct pp_study *study,
                                 const struct pp_simulation_request *request,
                                 struct pp_error *err);

/* Works for about `seconds` by the clock; after each call the columns ("traced" of
 * engine "path", "cached" of engine "cache", "photons" of engine "photons") hold what is
 * known so far. Whoever wants to stop does not call it again. */
enum pp_status pp_study_advance(struct pp_study *study, double seconds,
                                struct pp_error *err);
bool pp_study_done(const struct pp_study *study);

/* 0 to 1, by the work that there now seems to be; and the largest standard error over
 * daylight factor of any point, NAN before there is any. */
double pp_study_progress(const struct pp_study *study);
double pp_study_error(const struct pp_study *study);

/* A column is one component by one method, pair or engine. */
int pp_study_column_count(const struct pp_study *study);
const char *pp_study_column_name(const struct pp_study *study, int column);
enum pp_component pp_study_column_component(const struct pp_study *study, int column);

/* The column of that component and name ("exact+bre", "traced"), or -1. */
int pp_study_find(const struct pp_study *study, enum pp_component component,
                  const char *name);

/* At point `point`, or the average over the working plane for -1. */
struct pp_reading pp_study_reading(const struct pp_study *study, int column, int point);

/* ---- reports and charts ---- */

enum pp_format { PP_FORMAT_TEXT, PP_FORMAT_JSON, PP_FORMAT_CSV };

/* All that was found out, as `pepperpot df` prints it: *bytes (UTF-8, a zero behind
 * them) are the caller's to pp_free. */
enum pp_status pp_study_report(const struct pp_study *study, enum pp_format format,
                               char **bytes, size_t *length, struct pp_error *err);

enum pp_chart_format { PP_CHART_PDF, PP_CHART_SVG, PP_CHART_PNG };
enum pp_paper { PP_PAPER_A4, PP_PAPER_A5, PP_PAPER_A3, PP_PAPER_A2 };
enum pp_orientation { PP_AS_FITS, PP_PORTRAIT, PP_LANDSCAPE };

struct pp_chart_request {
    enum pp_chart_format format;
    enum pp_paper paper;
    enum pp_orientation orientation;
    double dpi;          /* of a PNG, 20 to 1200; 0: 200 */
    bool logarithmic;    /* section: daylight factors */
    const char *methods; /* whose figures; NULL: the default ones */
};

/* A chart, at true scale, as the bytes of a file. kind: of PP_LIST_CHARTS. study NULL: a
 * blank one, of the kinds worked at the drawing board. Of the room's figures hand
 * methods' are drawn, worked out anew. request NULL: a PDF on A4. */
enum pp_status pp_study_chart(const struct pp_study *study, const char *kind,
                              const struct pp_chart_request *request, char **bytes,
                              size_t *length, struct pp_error *err);

/* Geometry of the resolved room, for programs that draw it, as a JSON object
 * "pepperpot-scene-1": surfaces, openings, blocks, skylines and gardens, each with the
 * line of the file that it comes from, and the points. The caller frees *bytes. */
enum pp_status pp_study_scene(const struct pp_study *study, char **bytes,
                              size_t *length, struct pp_error *err);

/* Contours of the daylight factor on the working plane and the no-sky line, as a JSON
 * object "pepperpot-plan-1" of polylines. methods: one direct method or pair that gives a
 * figure at each place, NULL: the default pair. tolerance: of the lines' places, in metres;
 * 0.001 is that of a chart. The caller frees *bytes. */
enum pp_status pp_study_plan(const struct pp_study *study, const char *methods,
                             double tolerance, char **bytes, size_t *length,
                             struct pp_error *err);

/* ---- criteria and sizes ---- */

enum pp_verdict {
    PP_STATED, /* a figure that no criterion sets a bound for */
    PP_MET,
    PP_NOT_MET,
    PP_UNDECIDED, /* the figure's own error is too large to tell */
    PP_NOT_JUDGED /* the criterion does not speak of this room; the note says why */
};

/* One figure that a criterion asks for. Texts are the study's, good until the next
 * pp_study_judge. The confidence is about noise alone: of the house beside the room it
 * takes what the file says, where the command assess looks whether a larger one would
 * turn the verdict. */
struct pp_judgement {
    const char *criterion; /* of PP_LIST_CRITERIA */
    const char *what;      /* "W1, south" */
    double figure;         /* NAN: not judged */
    double std_error;      /* of it; NAN where nothing was sampled */
    double wanted;         /* NAN: stated */
    bool at_most;          /* wanted is the most, else the least */
    enum pp_verdict verdict;
    double confidence; /* probability that the verdict is right; NAN where nothing was
                        * sampled */
    const char *basis, *note; /* sentences; empty: nothing to add */
};

/* Holds the room against criteria: names with commas between, NULL for all.
 * median_diffuse_lux: of the place, for EN 17037; 0: by the room's site. */
enum pp_status pp_study_judge(struct pp_study *study, const char *criteria,
                              double median_diffuse_lux, struct pp_error *err);
int pp_study_judgement_count(const struct pp_study *study);
struct pp_judgement pp_study_judgement(const struct pp_study *study, int index);

enum pp_size_change {
    PP_CHANGE_WIDTH,
    PP_CHANGE_HEIGHT, /* of a rooflight: its depth, about its middle */
    PP_CHANGE_HEAD,
    PP_CHANGE_SILL,
    PP_CHANGE_NUMBER,
};

enum pp_size_verdict {
    PP_SIZE_REACHED,
    PP_SIZE_SMALLEST_EXCEEDS, /* even the smallest is above the target */
    PP_SIZE_OUT_OF_REACH,     /* no size reaches it; the best is given */
    PP_SIZE_NO_VALUE,         /* why says why */
};

struct pp_size_found {
    enum pp_size_verdict verdict;
    double now, value; /* of the room as it is, and at the size found; NAN: none */
    char method[64];   /* that it was sized by */
    char why[512];     /* there is no value; empty where there is one */
};

/* The smallest windows with which the average daylight factor over the working plane is
 * not below target, a fraction, by a hand method or pair (NULL: one that covers the
 * room). *file (may be NULL): the room file with the windows found, the caller's to
 * pp_free; NULL where the target is not reached. */
enum pp_status pp_study_size(const struct pp_study *study, double target,
                             enum pp_size_change change, const char *method,
                             struct pp_size_found *found, char **file,
                             struct pp_error *err);

/* ---- what there is ---- */

enum pp_list { PP_LIST_METHODS, PP_LIST_ENGINES, PP_LIST_CHARTS, PP_LIST_CRITERIA };

/* Name and summary (a line without a full stop) of entry `index`, from 0; NULL behind
 * the last. */
const char *pp_list_name(enum pp_list list, int index);
const char *pp_list_summary(enum pp_list list, int index);

#ifdef __cplusplus
}
#endif

#endif
