/* compare_report.c - prints the values, the causes with their effects, other
 * explanations, the remainder, and advice. */
#include "reports/compare/compare_report.h"

#include <math.h>
#include <string.h>

#include "model/base/text.h"
#include "reports/parts/format.h"
#include "reports/parts/json.h"
#include "reports/parts/print.h"

enum { TEXT_BYTES = 640 };

static const struct pp_cause *cause_of(const struct pp_compare_result *result,
                                       const struct pp_cause_set *set, int index)
{
    return result->causes[set->causes[index]];
}

/* Appends a cause with its value, if any: "bounces=2", "ground=0.4", "factor=1.12". */
static void append_word(char *text, size_t room, const struct pp_compare_result *result,
                        const struct pp_cause_set *set, int index)
{
    const struct pp_cause *cause = cause_of(result, set, index);
    pp_text_append(text, room, "%s", cause->word);
    if (cause->is_factor)
        pp_text_append(text, room, "=%.3g", exp(set->likelihood.theta));
    else if (pp_causes_is_fitted(cause))
        pp_text_append(text, room, "=%.3g", set->value);
}

/* Appends a list of causes, "bounces=2,glass=normal", or "nothing". */
static void append_words(char *text, size_t room,
                         const struct pp_compare_result *result,
                         const struct pp_cause_set *set)
{
    for (int i = 0; i < set->count; i++) {
        pp_text_append(text, room, "%s", i > 0 ? "," : "");
        append_word(text, room, result, set, i);
    }
    if (set->count == 0)
        pp_text_append(text, room, "nothing");
}

static const char *level(const struct pp_compared *compared, int cause)
{
    return pp_compare_is_sure(compared, cause)          ? "sure"
           : compared->search.probability[cause] >= 0.7 ? "likely"
                                                        : "perhaps";
}

/* Converts a difference of natural logarithms to per cent. */
static double per_cent(double logarithm)
{
    return 100.0 * (exp(logarithm) - 1.0);
}

/* ---- text ---- */

static void print_head(const struct pp_compare_result *result, int width, FILE *out)
{
    char text[TEXT_BYTES] = "";
    if (result->subject->room)
        pp_print_title(result->subject->room->world, result->subject->file, out);
    else
        fprintf(out, "%s\n", result->subject->file);
    if (result->variant)
        pp_text_append(text, sizeof text, "Our values use the switches %s. ",
                       result->variant);
    if (result->other && result->compared.count < result->given)
        pp_text_append(text, sizeof text,
                       "The comparison uses %d of the other program's %d points, "
                       "evenly selected. ",
                       result->compared.count, result->given);
    pp_text_append(
        text, sizeof text,
        "Daylight factors in per cent; +-: one standard error of our values.");
    fputs("\n  ", out);
    pp_print_wrapped(text, 2, 2, width, out);
}

/* Remaining difference in per cent; NAN, which is printed as a dash, if the explained
 * value is not greater than its error. */
static double left_percent(double theirs, double explained, double error)
{
    return explained > fmax(error, 1e-9) ? 100.0 * (theirs / explained - 1.0) : NAN;
}

static void print_values(const struct pp_compare_result *result, FILE *out)
{
    const struct pp_compared *compared = &result->compared;
    fprintf(out, "\n  %6s%7s%7s%9s%8s", "x", "y", "z", "ours", "+-");
    fputs(result->other   ? "    theirs   off, %  explained   left, %\n"
          : result->plain ? "  as it is   off, %\n"
                          : "\n",
          out);
    for (int i = 0; i < compared->count; i++) {
        struct pp_vec3 at = result->subject->points[i].position;
        double ours = compared->ours[i];
        fprintf(out, "  %6.2f%7.2f%7.2f%9.3f%8.3f", at.x, at.y, at.z, 100.0 * ours,
                100.0 * compared->errors[i]);
        if (result->other) {
            double theirs = compared->theirs[i], explained = compared->explained[i];
            fprintf(out, "%10.3f", 100.0 * theirs);
            pp_format_cell(100.0 * (theirs / ours - 1.0), "%+.1f", 9, out);
            fprintf(out, "%11.3f", 100.0 * explained);
            pp_format_cell(left_percent(theirs, explained, compared->errors[i]),
                           "%+.1f", 10, out);
        } else if (result->plain) {
            fprintf(out, "%10.3f", 100.0 * result->plain[i]);
            pp_format_cell(100.0 * (ours / result->plain[i] - 1.0), "%+.1f", 9, out);
        }
        fputc('\n', out);
    }
}

static void print_item(const char *label, const char *text, int width, FILE *out)
{
    fprintf(out, "    %-9s", label);
    pp_print_wrapped(text, 13, 13, width, out);
}

static void print_causes(const struct pp_compare_result *result, int width, FILE *out)
{
    const struct pp_compared *compared = &result->compared;
    const struct pp_cause_set *set = &compared->search.sets[0];
    for (int i = 0; i < set->count; i++) {
        char text[TEXT_BYTES] = "";
        double probability = compared->search.probability[set->causes[i]];
        append_word(text, sizeof text, result, set, i);
        pp_text_append(text, sizeof text,
                       ": %s. This changes the mean by %+.1f %% and explains %.0f %% "
                       "of the difference (probability %.0f %%).",
                       cause_of(result, set, i)->action, per_cent(compared->effects[i]),
                       100.0 * compared->shares[i], 100.0 * fmin(probability, 0.99));
        print_item(level(compared, set->causes[i]), text, width, out);
    }
}

static void print_instead(const struct pp_compare_result *result, int width, FILE *out)
{
    const struct pp_compared *compared = &result->compared;
    for (int i = 1; i < compared->listed; i++) {
        char text[TEXT_BYTES] = "";
        const struct pp_cause_set *set = &compared->search.sets[i];
        append_words(text, sizeof text, result, set);
        pp_text_append(text, sizeof text, " (%.0f %%; the causes above: %.0f %%)",
                       100.0 * set->probability,
                       100.0 * compared->search.sets[0].probability);
        print_item(i == 1 ? "or it is" : "or", text, width, out);
    }
}

/* Appends the size of the unexplained remainder, and its variation between points. */
static void append_left(char text[TEXT_BYTES], const struct pp_compared *compared)
{
    const struct pp_likelihood *noise = &compared->search.sets[0].likelihood;
    pp_text_append(
        text, TEXT_BYTES,
        "%.1f %% root mean square, %+.1f %% on average. The remainder varies ",
        100.0 * compared->left_rms, per_cent(compared->left));
    pp_text_append(
        text, TEXT_BYTES,
        noise->near > 0.9
            ? "together at neighbouring points, which suggests interpolation in a cache"
        : noise->near < 0.1
            ? "independently from point to point, which suggests too few rays"
            : "in a way that suggests too few rays or interpolation in a cache");
    pp_text_append(text, TEXT_BYTES, " (standard deviation %.1f %%).",
                   100.0 * noise->sigma);
    double share = compared->left_rms / compared->gap_rms;
    if (noise->sigma > PP_COMPARE_HIDES)
        pp_text_append(text, TEXT_BYTES,
                       " This noise is large: it accounts for %.0f %% of the "
                       "difference and may mimic or mask causes. No cause is certain.",
                       100.0 * fmin(1.0, share * share));
    if (compared->search.is_cut)
        pp_text_append(text, TEXT_BYTES,
                       " Some plausible combinations of causes were not simulated.");
}

/* Appends a sentence, unless the noise of the other program explains the remainder. */
static void append_over(char text[TEXT_BYTES], const struct pp_left_over *over)
{
    if (pp_left_over_is_noise(over))
        return;
    if (pp_left_over_exceeds(over))
        pp_text_append(
            text, TEXT_BYTES,
            "The remainder of %.1f %% is larger than the other program's noise: noise "
            "of %.1f %% per point explains only %.1f %%. A cause is missing from the "
            "list, or the other values are interpolated. No cause is certain.",
            100.0 * over->left, 100.0 * over->noise, 100.0 * over->limit);
    else
        pp_text_append(text, TEXT_BYTES,
                       "There are too few points to separate noise from a mistake. No "
                       "cause is certain. Specify the noise with --noise.");
}

static void append_missing(char text[TEXT_BYTES])
{
    const char *missing;
    for (int i = 0; (missing = pp_causes_missing_at(i)) != NULL; i++)
        pp_text_append(text, TEXT_BYTES, "%s%s", i > 0 ? "; " : "", missing);
    pp_text_append(text, TEXT_BYTES,
                   ". Such mistakes can have the same effect as the causes above.");
}

/* Advice on how to reduce the noise; NULL: there is little noise. */
static const char *cure_of_noise(const struct pp_likelihood *noise)
{
    return noise->sigma < PP_COMPARE_NOISY ? NULL
           : noise->near > 0.9
               ? "switch off interpolation between points (rtrace -aa 0), or reduce it "
                 "(a smaller -aa)"
           : noise->near < 0.1 ? "use more rays (rtrace -ad 4096 or more)"
                               : "use more rays (rtrace -ad 4096 or more) and switch "
                                 "off interpolation between points (rtrace -aa 0)";
}

static void print_cures(const struct pp_compare_result *result, int width, FILE *out)
{
    const struct pp_compared *compared = &result->compared;
    const struct pp_cause_set *set = &compared->search.sets[0];
    const char *noise = cure_of_noise(&set->likelihood);
    if (set->count > 0 || noise)
        fputs("\n  Corrections in the other program\n\n", out);
    for (int i = 0; i < set->count; i++) {
        bool sure = pp_compare_is_sure(compared, set->causes[i]);
        print_item(sure ? "" : "perhaps", cause_of(result, set, i)->remedy, width, out);
    }
    if (noise)
        print_item("noise", noise, width, out);
}

static void print_found(const struct pp_compare_result *result, int width, FILE *out)
{
    const struct pp_compared *compared = &result->compared;
    char text[TEXT_BYTES] = "";
    pp_text_append(text, sizeof text,
                   "The other program's values are %.1f %% %s than ours on average "
                   "(%.1f %% root mean square). Causes:",
                   fabs(per_cent(compared->gap)),
                   compared->gap < 0.0 ? "lower" : "higher", 100.0 * compared->gap_rms);
    fputs("\n  ", out);
    pp_print_wrapped(text, 2, 2, width, out);
    fputc('\n', out);
    if (compared->search.sets[0].count == 0)
        print_item(
            "nothing",
            "no cause on the list explains the difference better than noise does",
            width, out);
    print_causes(result, width, out);
    print_instead(result, width, out);
    text[0] = '\0';
    append_left(text, compared);
    print_item("left", text, width, out);
    text[0] = '\0';
    append_over(text, &compared->over);
    if (text[0])
        print_item("unknown", text, width, out);
    text[0] = '\0';
    append_missing(text);
    print_item("untested", text, width, out);
    print_cures(result, width, out);
}

void pp_compare_report(const struct pp_compare_result *result, int width, FILE *out)
{
    print_head(result, width, out);
    print_values(result, out);
    if (result->other)
        print_found(result, width, out);
}

/* ---- JSON ---- */

static struct json_object *point_object(const struct pp_compare_result *result, int i)
{
    const struct pp_compared *compared = &result->compared;
    struct pp_vec3 at = result->subject->points[i].position;
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_number(object, "x", at.x)
                && pp_json_number(object, "y", at.y)
                && pp_json_number(object, "z", at.z)
                && pp_json_number(object, "ours", 100.0 * compared->ours[i])
                && pp_json_number(object, "ours-se", 100.0 * compared->errors[i]);
    if (good && result->plain)
        good = pp_json_number(object, "as-it-is", 100.0 * result->plain[i]);
    if (good && result->other)
        good = pp_json_number(object, "theirs", 100.0 * compared->theirs[i])
               && pp_json_number(object, "explained", 100.0 * compared->explained[i]);
    if (good)
        pp_json_on_one_line(object);
    return pp_json_whole(object, good);
}

static struct json_object *cause_object(const struct pp_compare_result *result, int i)
{
    const struct pp_compared *compared = &result->compared;
    const struct pp_cause_set *set = &compared->search.sets[0];
    const struct pp_cause *cause = cause_of(result, set, i);
    double probability = compared->search.probability[set->causes[i]];
    char word[64] = "";
    append_word(word, sizeof word, result, set, i);
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_text(object, "switch", word)
                && pp_json_number(object, "probability", probability)
                && pp_json_add(object, "sure",
                               json_object_new_boolean(
                                   pp_compare_is_sure(compared, set->causes[i])))
                && pp_json_number(object, "mean-change", per_cent(compared->effects[i]))
                && pp_json_number(object, "share", 100.0 * compared->shares[i])
                && pp_json_text(object, "cause", cause->action)
                && pp_json_text(object, "cure", cause->remedy);
    return pp_json_whole(object, good);
}

static struct json_object *set_object(const struct pp_compare_result *result, int i)
{
    const struct pp_cause_set *set = &result->compared.search.sets[i];
    char words[256] = "";
    append_words(words, sizeof words, result, set);
    struct json_object *object = json_object_new_object();
    bool good = object && pp_json_text(object, "switches", set->count ? words : "")
                && pp_json_number(object, "probability", set->probability);
    if (good)
        pp_json_on_one_line(object);
    return pp_json_whole(object, good);
}

static struct json_object *missing_array(void)
{
    struct json_object *array = json_object_new_array();
    const char *missing;
    bool good = array != NULL;
    for (int i = 0; good && (missing = pp_causes_missing_at(i)) != NULL; i++)
        good = pp_json_append(array, json_object_new_string(missing));
    return pp_json_whole(array, good);
}

static bool add_found(struct json_object *object,
                      const struct pp_compare_result *result)
{
    const struct pp_compared *compared = &result->compared;
    const struct pp_cause_set *set = &compared->search.sets[0];
    struct json_object *causes = json_object_new_array();
    struct json_object *sets = json_object_new_array();
    bool good = pp_json_add(object, "causes", causes);
    good = pp_json_add(object, "sets", sets) && good;
    for (int i = 0; i < set->count && good; i++)
        good = pp_json_append(causes, cause_object(result, i));
    for (int i = 0; i < compared->listed && good; i++)
        good = pp_json_append(sets, set_object(result, i));
    return good && pp_json_number(object, "difference-mean", per_cent(compared->gap))
           && pp_json_number(object, "difference-rms", 100.0 * compared->gap_rms)
           && pp_json_number(object, "left-mean", per_cent(compared->left))
           && pp_json_number(object, "left-rms", 100.0 * compared->left_rms)
           && pp_json_number(object, "noise", 100.0 * set->likelihood.sigma)
           && pp_json_number(object, "noise-of-neighbours-alike", set->likelihood.near)
           && pp_json_number(object, "noise-of-points", 100.0 * compared->over.noise)
           && pp_json_number(object, "left-smooth", 100.0 * compared->over.left)
           && pp_json_number(object, "left-limit", 100.0 * compared->over.limit)
           && pp_json_add(
               object, "left-exceeds-noise",
               json_object_new_boolean(pp_left_over_exceeds(&compared->over)))
           && pp_json_add(object, "not-detected", missing_array())
           && pp_json_add(
               object, "noise-may-hide-causes",
               json_object_new_boolean(set->likelihood.sigma > PP_COMPARE_HIDES));
}

enum pp_status pp_compare_report_json(const struct pp_compare_result *result, FILE *out,
                                      struct pp_error *err)
{
    struct json_object *object = json_object_new_object();
    struct json_object *points = json_object_new_array();
    bool good = object && pp_json_text(object, "format", "pepperpot-compare-1")
                && pp_json_text(object, "file", result->subject->file);
    if (good && result->subject->room)
        good = pp_json_text(object, "room", result->subject->name);
    if (good && result->other)
        good =
            pp_json_text(object, "other", result->other)
            && pp_json_add(object, "points-given", json_object_new_int(result->given));
    if (good && result->variant)
        good = pp_json_text(object, "as-if", result->variant);
    good = pp_json_add(object, "points", points) && good;
    for (int i = 0; i < result->compared.count && good; i++)
        good = pp_json_append(points, point_object(result, i));
    if (good && result->other)
        good = add_found(object, result);
    return pp_json_print(out, pp_json_whole(object, good), err);
}
