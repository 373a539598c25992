/* compare_causes.c - tests whether compare finds known causes of deviations:
 *
 *     compare_causes listed|foreign SEED CASES ROOM.xml...
 *
 * Each case takes one of the rooms and one, two or three random causes of different
 * kinds, traces their values with another seed, and adds noise of 0.5 to 3 %, either
 * independent by point (few rays) or correlated between neighbours (a cache). A case is
 * right if the true set of causes is listed, exact if it is the likeliest. A cause that
 * is reported as sure but is not in the true set is a false accusation. Prints one line
 * per case, and sums. For speed, the benchmark uses at most 16 points and 20 traced
 * sets, to 1.5 %; compare itself is more accurate.
 *
 * Foreign cases have a mistake that compare does not list (compare_foreign.h), half of
 * them together with one that it lists. In these cases no set is right, and any other
 * cause that is reported as sure is a false accusation.
 */
#include <math.h>

#include "bench/bench.h"
#include "bench/compare_foreign.h"
#include "simulate/sampling/hash.h"
#include "studies/research/compare/compare.h"
#include "studies/research/compare/variant_values.h"

enum { MOST_POINTS = 16, ROOMS_MOST = 40 };
/* Least effect of a single cause (RMS of logarithms); a smaller effect cannot be found.
 * The effect must also exceed the noise. */
static const double LEAST_EFFECT = 0.01;

struct room {
    const char *file;
    char *text;
    struct pp_building *building;
    struct pp_study_room study;
    struct pp_compare *compare;
};

struct tally {
    int cases, right, exact, alike, accused, falsely, wrong_cases, listed, left;
    int of[PP_CAUSE_SEARCH_MOST + 1], right_of[PP_CAUSE_SEARCH_MOST + 1];
};

/* Uniform random number in (0, 1) from a seed, the case and its purpose. */
static double even(uint64_t seed, int number, int what, int more)
{
    uint64_t hash = pp_hash(pp_hash(pp_hash(seed, (uint64_t)number), (uint64_t)what),
                            (uint64_t)more);
    return ((double)(hash >> 11) + 0.5) / 9007199254740992.0;
}

static double normal(uint64_t seed, int number, int what, int more)
{
    return sqrt(-2.0 * log(even(seed, number, what, more)))
           * cos(2.0 * PP_PI * even(seed, number, what + 1, more));
}

/* Opens the file's first room with at most MOST_POINTS of its points, evenly
 * selected. */
static void open_room(struct room *room, const char *path)
{
    char *text = pp_foreign_text_of(path);
    if (!text || !pp_foreign_room(&room->building, &room->study, path, text)) {
        fprintf(stderr, "bench: %s can't be read\n", path);
        exit(1);
    }
    room->file = path;
    room->text = text;
    int count = room->study.receiver_count,
        kept = count < MOST_POINTS ? count : MOST_POINTS;
    struct pp_receiver *receivers = calloc((size_t)kept, sizeof *receivers);
    for (int i = 0; receivers && i < kept; i++)
        receivers[i] = room->study.receivers[(long)i * count / kept];
    pp_study_room_set_points(&room->study, receivers, kept);
    struct pp_error err;
    const struct pp_compare_options options = {
        .variant = pp_room_variant_nothing(),
        .tracing = {.error = 0.015, .seed = 1, .threads = 1},
        .traced_most = 20};
    const struct pp_compare_subject subject = pp_compare_subject_of_room(&room->study);
    must(pp_compare_create(&room->compare, &subject, &options, &err), &err);
}

/* True if the values differ from the values traced without a cause by more than the
 * noise and by more than LEAST_EFFECT. */
static bool differs(const struct room *room, const double *values, double sigma)
{
    double sum = 0.0;
    const double *se, *ours = pp_compare_ours(room->compare, &se);
    for (int i = 0; i < room->study.receiver_count; i++) {
        double effect = log(values[i] / ours[i]);
        sum += effect * effect / room->study.receiver_count;
    }
    return sqrt(sum) > fmax(sigma, LEAST_EFFECT);
}

/* True if the cause alone has a sufficient effect. */
static bool is_felt(const struct room *room, const struct pp_cause *cause,
                    double ground, double sigma)
{
    double values[PP_COMPARE_POINTS_MOST], errors[PP_COMPARE_POINTS_MOST];
    const struct pp_variant_tracing tracing = {.error = 0.015, .seed = 1, .threads = 1};
    struct pp_room_variant variant = pp_room_variant_nothing();
    struct pp_error err;
    if (cause->is_factor)
        return true;
    must(pp_causes_set_variant(&variant, cause, ground, &err), &err);
    if (pp_variant_values(values, errors, &room->study, &variant, &tracing, &err)
        != PP_OK)
        return false; /* for example, points on a floor with a step */
    return variant.dark || differs(room, values, sigma);
}

/* Draws up to `wanted` causes of different kinds and sorts them in ascending order. A
 * cause that excludes all others, such as "no light at all", is only drawn alone.
 * Returns the number of causes. */
static int draw_causes(int causes[PP_CAUSE_SEARCH_MOST], const struct room *room,
                       uint64_t seed, int number, int wanted, double ground,
                       double sigma)
{
    const struct pp_cause *const *list;
    int count = pp_compare_causes(room->compare, &list), drawn = 0;
    for (int attempt = 0; drawn < wanted && attempt < 100; attempt++) {
        /* Accepts a cause with a probability inversely proportional to the number of
         * causes of its kind, so that all kinds are equally likely. */
        int at = (int)(count * even(seed, number, 2, attempt)), alike = 0;
        bool fits = true;
        for (int i = 0; i < count; i++)
            alike += strcmp(list[i]->kind, list[at]->kind) == 0;
        for (int i = 0; i < drawn; i++)
            fits = fits && strcmp(list[causes[i]]->kind, list[at]->kind) != 0;
        fits = fits && even(seed, number, 3, attempt) < 1.0 / alike
               && (drawn == 0 || !list[at]->is_alone)
               && is_felt(room, list[at], ground, sigma);
        if (fits)
            causes[drawn++] = at;
        if (fits && list[at]->is_alone)
            break;
    }
    for (int i = 1; i < drawn; i++)
        for (int k = i; k > 0 && causes[k] < causes[k - 1]; k--) {
            int swap = causes[k];
            causes[k] = causes[k - 1];
            causes[k - 1] = swap;
        }
    return drawn;
}

/* Draws noise of standard deviation 1 for each point. */
static void draw_noise(double *noise, const struct room *room, uint64_t seed,
                       int number)
{
    int count = room->study.receiver_count;
    bool alike = even(seed, number, 10, 0) < 0.3;
    double reach_m = 0.5 + 1.5 * even(seed, number, 11, 0);
    for (int i = 0; i < count; i++) {
        double sum = 0.0, weights = 0.0;
        for (int k = 0; alike && k < count; k++) {
            double far = pp_vec_length(pp_vec_sub(room->study.receivers[i].position,
                                                  room->study.receivers[k].position))
                         / reach_m;
            double weight = exp(-far * far);
            sum += weight * normal(seed, number, 20, k);
            weights += weight * weight;
        }
        noise[i] = alike ? sum / sqrt(weights) : normal(seed, number, 20, i);
    }
}

static const char *causes_text(char text[200], const struct room *room,
                               const int *causes, int count)
{
    const struct pp_cause *const *list;
    pp_compare_causes(room->compare, &list);
    text[0] = '\0';
    for (int i = 0; i < count; i++)
        snprintf(text + strlen(text), 200 - strlen(text), "%s%s", i ? "," : "",
                 list[causes[i]]->word);
    return text;
}

/* True if noise can explain the difference between the values of the likeliest set and
 * the values of the true causes: the sum over points of squared difference over
 * variance is below 3^2 plus the part expected from our own simulation errors. */
static bool cannot_be_told(const struct pp_compared *compared, const double *causes,
                           double sigma)
{
    double sum = 0.0, expected = 0.0, dark = 0.0;
    for (int i = 0; i < compared->count; i++)
        dark += 0.005 * compared->ours[i] / compared->count;
    for (int i = 0; i < compared->count; i++) {
        double error = compared->errors[i] / (compared->ours[i] + dark);
        double off = log((compared->explained[i] + dark) / (causes[i] + dark));
        double variance = sigma * sigma + 2.0 * error * error;
        sum += off * off / variance;
        expected += 2.0 * error * error / variance;
    }
    return sum < 9.0 + expected;
}

/* Counts causes reported as sure that are not in the true set. */
static int accused_falsely(struct tally *tally, const struct room *room,
                           const struct pp_compared *compared, const int *causes,
                           int count)
{
    const struct pp_cause *const *list;
    int listed = pp_compare_causes(room->compare, &list), wrong = 0;
    for (int i = 0; i < listed; i++) {
        bool is_cause = false;
        for (int k = 0; k < count; k++)
            is_cause = is_cause || causes[k] == i;
        tally->accused += pp_compare_is_sure(compared, i);
        wrong += pp_compare_is_sure(compared, i) && !is_cause;
    }
    tally->falsely += wrong;
    tally->wrong_cases += wrong > 0;
    return wrong;
}

/* Position of the true set among the listed sets; -1: not listed. */
static int place_of(const struct pp_compared *compared, const int *causes, int count)
{
    for (int i = 0; i < compared->listed; i++)
        if (compared->search.sets[i].count == count
            && memcmp(compared->search.sets[i].causes, causes,
                      (size_t)count * sizeof *causes)
                   == 0)
            return i;
    return -1;
}

static void print_case(const struct room *room, const struct pp_compared *compared,
                       const char *was, const char *verdict, int wrong, double sigma)
{
    char named[200];
    const struct pp_cause_set *set = &compared->search.sets[0];
    printf("%-24.24s %-40s s %.1f %%  %s of %d: %s (%.2f) left %.1f noise %.1f%s%s%s\n",
           strrchr(room->file, '/') ? strrchr(room->file, '/') + 1 : room->file, was,
           100.0 * sigma, verdict, compared->listed,
           causes_text(named, room, set->causes, set->count), set->probability,
           100.0 * compared->over.left, 100.0 * compared->over.noise,
           pp_left_over_exceeds(&compared->over) ? " more" : "", wrong ? " FALSE" : "",
           compared->search.is_cut ? " cut" : "");
    fflush(stdout);
}

/* Traces the values that the causes produce, with `factor` if a common factor is a
 * cause; the caller adds the noise. truth: the same values, traced as accurately as
 * compare's own values; NULL: not traced. */
static void trace_causes(double *theirs, double *truth,
                         const struct pp_study_room *study, const struct room *room,
                         const int *causes, int count, double ground, double factor,
                         uint64_t seed)
{
    double errors[PP_COMPARE_POINTS_MOST];
    struct pp_room_variant variant = pp_room_variant_nothing();
    const struct pp_cause *const *list;
    struct pp_error err;
    pp_compare_causes(room->compare, &list);
    for (int i = 0; i < count; i++) {
        if (list[causes[i]]->is_factor)
            variant.factor = factor;
        else
            must(pp_causes_set_variant(&variant, list[causes[i]], ground, &err), &err);
    }
    const struct pp_variant_tracing tracing = {
        .error = 0.006, .seed = seed, .threads = 1};
    const struct pp_variant_tracing ours = {.error = 0.015, .seed = 1, .threads = 1};
    must(pp_variant_values(theirs, errors, study, &variant, &tracing, &err), &err);
    if (truth)
        must(pp_variant_values(truth, errors, study, &variant, &ours, &err), &err);
}

static double drawn_factor(uint64_t seed, int number)
{
    double u = 2.0 * even(seed, number, 5, 0) - 1.0;
    return exp(u < 0.0 ? -0.05 + 0.4 * u : 0.05 + 0.4 * u);
}

static uint64_t tracing_seed(uint64_t seed, int number)
{
    return 1000 + seed * 1000 + (uint64_t)number;
}

static void add_noise(double *theirs, const struct room *room, uint64_t seed,
                      int number, double sigma)
{
    double noise[PP_COMPARE_POINTS_MOST];
    draw_noise(noise, room, seed, number);
    for (int i = 0; i < room->study.receiver_count; i++)
        theirs[i] *= exp(sigma * noise[i]);
}

static void run_listed(struct tally *tally, struct room *room, uint64_t seed,
                       int number)
{
    double theirs[PP_COMPARE_POINTS_MOST], truth[PP_COMPARE_POINTS_MOST];
    double sigma = 0.005 * pow(6.0, even(seed, number, 4, 0));
    double ground = PP_CAUSES_VALUE_MOST * even(seed, number, 6, 0);
    int causes[PP_CAUSE_SEARCH_MOST],
        wanted = 1 + (int)(3.0 * even(seed, number, 1, 0));
    int count = draw_causes(causes, room, seed, number, wanted, ground, sigma);
    struct pp_error err;
    struct pp_compared compared;
    char was[200];
    trace_causes(theirs, truth, &room->study, room, causes, count, ground,
                 drawn_factor(seed, number), tracing_seed(seed, number));
    add_noise(theirs, room, seed, number, sigma);
    must(pp_compare_explain(&compared, room->compare, theirs, &err), &err);
    int place = place_of(&compared, causes, count);
    bool alike = place >= 0 || cannot_be_told(&compared, truth, sigma);
    int wrong = accused_falsely(tally, room, &compared, causes, count);
    tally->cases++;
    tally->of[count]++;
    tally->right += place >= 0;
    tally->right_of[count] += place >= 0;
    tally->exact += place == 0;
    tally->alike += alike;
    tally->listed += compared.listed;
    tally->left += pp_left_over_exceeds(&compared.over);
    print_case(room, &compared, causes_text(was, room, causes, count),
               place == 0  ? "exact"
               : place > 0 ? "right"
               : alike     ? "alike"
                           : "WRONG",
               wrong, sigma);
    pp_compare_clear(&compared);
}

/* Draws a mistake that is not on the list but has a sufficient effect. `changed` is the
 * room with the mistake, at the points of the original room. */
static const char *draw_foreign(struct pp_building **building,
                                struct pp_study_room *changed, struct room *room,
                                uint64_t seed, int number, double sigma)
{
    double values[PP_COMPARE_POINTS_MOST];
    int count = room->study.receiver_count;
    for (int attempt = 0; attempt < 100; attempt++) {
        const char *word = pp_foreign_draw(
            building, changed, room->file, room->text, room->study.receivers, count,
            even(seed, number, 7, attempt), even(seed, number, 8, attempt));
        if (!word)
            continue;
        trace_causes(values, NULL, changed, room, NULL, 0, 0.0, 1.0, 1);
        if (differs(room, values, sigma))
            return word;
        pp_study_room_clear(changed);
        pp_building_destroy(*building);
    }
    fprintf(stderr, "bench: nothing foreign can be done to %s\n", room->file);
    exit(1);
}

static void run_foreign(struct tally *tally, struct room *room, uint64_t seed,
                        int number)
{
    double theirs[PP_COMPARE_POINTS_MOST];
    double sigma = 0.005 * pow(6.0, even(seed, number, 4, 0));
    double ground = PP_CAUSES_VALUE_MOST * even(seed, number, 6, 0);
    int causes[PP_CAUSE_SEARCH_MOST], wanted = even(seed, number, 1, 0) < 0.5 ? 0 : 1;
    int count = draw_causes(causes, room, seed, number, wanted, ground, sigma);
    struct pp_building *building;
    struct pp_study_room changed;
    struct pp_error err;
    struct pp_compared compared;
    char was[200], text[300];
    const char *word = draw_foreign(&building, &changed, room, seed, number, sigma);
    snprintf(text, sizeof text, "%s%s%s", word, count ? "," : "",
             causes_text(was, room, causes, count));
    trace_causes(theirs, NULL, &changed, room, causes, count, ground,
                 drawn_factor(seed, number), tracing_seed(seed, number));
    add_noise(theirs, room, seed, number, sigma);
    must(pp_compare_explain(&compared, room->compare, theirs, &err), &err);
    int wrong = accused_falsely(tally, room, &compared, causes, count);
    tally->cases++;
    tally->left += pp_left_over_exceeds(&compared.over);
    print_case(room, &compared, text, "foreign", wrong, sigma);
    pp_compare_clear(&compared);
    pp_study_room_clear(&changed);
    pp_building_destroy(building);
}

static void print_listed(const struct tally *tally)
{
    printf(
        "%d cases: %d right (%d exact, %.1f sets listed a case), %d right or not to be "
        "told; with one cause %d of %d, two %d of %d, three %d of %d\n",
        tally->cases, tally->right, tally->exact, (double)tally->listed / tally->cases,
        tally->alike, tally->right_of[1], tally->of[1], tally->right_of[2],
        tally->of[2], tally->right_of[3], tally->of[3]);
}

int main(int argc, char **argv)
{
    static struct room rooms[ROOMS_MOST];
    struct tally tally = {0};
    int room_count = argc - 4;
    bool foreign = argc > 1 && strcmp(argv[1], "foreign") == 0;
    if (room_count < 1 || room_count > ROOMS_MOST) {
        fputs("Usage: compare_causes listed|foreign SEED CASES ROOM.xml...\n", stderr);
        return 2;
    }
    uint64_t seed = strtoull(argv[2], NULL, 10);
    int cases = atoi(argv[3]);
    double began_s = processor_s();
    for (int i = 0; i < room_count; i++)
        open_room(&rooms[i], argv[4 + i]);
    for (int number = 0; number < cases; number++)
        (foreign ? run_foreign : run_listed)(&tally, &rooms[number % room_count], seed,
                                             number);
    if (!foreign)
        print_listed(&tally);
    printf("%d cases: more is left than noise in %d; %d suspects called sure, %d of "
           "them falsely, in %d cases; %.0f s\n",
           tally.cases, tally.left, tally.accused, tally.falsely, tally.wrong_cases,
           processor_s() - began_s);
    for (int i = 0; i < room_count; i++) {
        pp_compare_destroy(rooms[i].compare);
        pp_study_room_clear(&rooms[i].study);
        pp_building_destroy(rooms[i].building);
        free(rooms[i].text);
    }
    return 0;
}
