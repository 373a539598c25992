/* compare_causes.c - cases with known causes, and whether compare names them:
 *
 *     compare_causes SEED CASES ROOM.xml...
 *
 * Each case takes one of the rooms, one, two or three suspects at random (no two of a
 * kind), traces their values from another seed, and puts noise on them: of 0.5 to 3 %, of
 * each point by itself (few rays) or alike at neighbours (a cache). A case is right where
 * the true set is among those that are listed; exact where it is the likeliest; a
 * suspect that is called sure and is not of the true set is a false accusation. Prints a
 * line a case, and the sums. */
#include <math.h>

#include "bench/bench.h"
#include "simulate/sampling/hash.h"
#include "studies/compare/as_if_values.h"
#include "studies/compare/compare.h"

enum { MOST_POINTS = 20, ROOMS_MOST = 40 };
/* A cause does at least that much by itself (root mean square of logarithms), or as much
 * as the noise: what does less is not there to be found. */
static const double LEAST_EFFECT = 0.01;

struct room {
    const char *file;
    struct pp_building *building;
    struct pp_study_room study;
    struct pp_compare *compare;
};

struct tally {
    int cases, right, exact, alike, accused, falsely, wrong_cases, listed;
    int of[PP_BLAME_MOST + 1], right_of[PP_BLAME_MOST + 1];
};

/* Even in (0, 1), by what it is for. */
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

static char *text_of(const char *path)
{
    FILE *file = fopen(path, "r");
    char *text = calloc(1, 1 << 20);
    if (!file || !text || fread(text, 1, (1 << 20) - 1, file) == 0) {
        fprintf(stderr, "bench: %s can't be read\n", path);
        exit(1);
    }
    fclose(file);
    return text;
}

/* The file's first room, with MOST_POINTS of its points, evenly. */
static void read_room(struct room *room, const char *path)
{
    struct pp_mistakes mistakes;
    struct pp_error err = {.message = "the room has mistakes"};
    struct pp_world *world;
    struct pp_outside_light light;
    char *text = text_of(path);
    pp_mistakes_init(&mistakes, path);
    must(pp_building_parse(&room->building, text, strlen(text), &mistakes, &err), &err);
    const struct pp_room *description = pp_building_room(room->building, 0);
    must(pp_world_create(&world, description, &mistakes, &err), &err);
    must(pp_room_light(&light, description, &err), &err);
    pp_mistakes_clear(&mistakes);
    free(text);
    room->file = path;
    pp_study_room_init(&room->study, path, room->building, 0, description, world,
                       &light);
    int count = world->receiver_count, kept = count < MOST_POINTS ? count : MOST_POINTS;
    struct pp_receiver *receivers = calloc((size_t)kept, sizeof *receivers);
    for (int i = 0; receivers && i < kept; i++)
        receivers[i] = world->receivers[(long)i * count / kept];
    pp_study_room_set_points(&room->study, receivers, kept);
    const struct pp_compare_options options = {
        .as_if = pp_as_if_nothing(),
        .tracing = {.error = 0.008, .seed = 1, .threads = 1}};
    const struct pp_compare_subject subject = pp_compare_subject_of_room(&room->study);
    must(pp_compare_create(&room->compare, &subject, &options, &err), &err);
}

/* Does the suspect do enough by itself? */
static bool is_felt(const struct room *room, const struct pp_suspect *suspect,
                    double sigma)
{
    double values[PP_COMPARE_POINTS_MOST], errors[PP_COMPARE_POINTS_MOST], sum = 0.0;
    const double *se, *ours = pp_compare_ours(room->compare, &se);
    const struct pp_as_if_tracing tracing = {.error = 0.008, .seed = 1, .threads = 1};
    struct pp_as_if as_if = pp_as_if_nothing();
    struct pp_error err;
    if (suspect->is_factor)
        return true;
    must(pp_as_if_add(&as_if, suspect->word, &err), &err);
    if (pp_as_if_values(values, errors, &room->study, &as_if, &tracing, &err) != PP_OK)
        return false; /* such as points on a floor with a step */
    if (as_if.dark)
        return true;
    for (int i = 0; i < room->study.receiver_count; i++) {
        double effect = log(values[i] / ours[i]);
        sum += effect * effect / room->study.receiver_count;
    }
    return sqrt(sum) > fmax(sigma, LEAST_EFFECT);
}

/* One, two or three suspects, no two of a kind, and nothing beside no light at all;
 * ascending. */
static int draw_causes(int causes[PP_BLAME_MOST], const struct room *room,
                       uint64_t seed, int number, double sigma)
{
    const struct pp_suspect *const *list;
    int count = pp_compare_suspects(room->compare, &list), drawn = 0;
    int wanted = 1 + (int)(3.0 * even(seed, number, 1, 0));
    for (int attempt = 0; drawn < wanted && attempt < 100; attempt++) {
        /* A kind first, then one of it: a kind is as likely as the next. */
        int at = (int)(count * even(seed, number, 2, attempt)), alike = 0;
        bool fits = true;
        for (int i = 0; i < count; i++)
            alike += strcmp(list[i]->kind, list[at]->kind) == 0;
        for (int i = 0; i < drawn; i++)
            fits = fits && strcmp(list[causes[i]]->kind, list[at]->kind) != 0;
        fits = fits && even(seed, number, 3, attempt) < 1.0 / alike
               && (drawn == 0 || !list[at]->is_alone) && is_felt(room, list[at], sigma);
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

/* Noise at each point, of standard deviation 1. */
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
    const struct pp_suspect *const *list;
    pp_compare_suspects(room->compare, &list);
    text[0] = '\0';
    for (int i = 0; i < count; i++)
        snprintf(text + strlen(text), 200 - strlen(text), "%s%s", i ? "," : "",
                 list[causes[i]]->word);
    return text;
}

/* Is what the likeliest set explains nearer to what the true causes do than noise tells:
 * by less than three standard errors of all points together, beyond what our own tracing
 * errs by? */
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

static void judge(struct tally *tally, const struct room *room,
                  const struct pp_compared *compared, const int *causes, int count,
                  const double *truth, double sigma)
{
    const struct pp_blame *blame = &compared->blame;
    const struct pp_suspect *const *list;
    int suspects = pp_compare_suspects(room->compare, &list), wrong = 0, place = -1;
    for (int i = 0; i < compared->listed && place < 0; i++)
        if (blame->sets[i].count == count
            && memcmp(blame->sets[i].suspects, causes, (size_t)count * sizeof *causes)
                   == 0)
            place = i;
    for (int i = 0; i < suspects; i++) {
        bool is_cause = false;
        for (int k = 0; k < count; k++)
            is_cause = is_cause || causes[k] == i;
        tally->accused += pp_compare_is_sure(compared, i);
        wrong += pp_compare_is_sure(compared, i) && !is_cause;
    }
    bool alike = cannot_be_told(compared, truth, sigma);
    tally->cases++;
    tally->of[count]++;
    tally->right += place >= 0;
    tally->right_of[count] += place >= 0;
    tally->exact += place == 0;
    tally->alike += place >= 0 || alike;
    tally->falsely += wrong;
    tally->wrong_cases += wrong > 0;
    tally->listed += compared->listed;
    char was[200], named[200];
    printf("%-28.28s %-44s s %.1f %%  %s of %d: %s (%.2f)%s%s\n",
           strrchr(room->file, '/') ? strrchr(room->file, '/') + 1 : room->file,
           causes_text(was, room, causes, count), 100.0 * sigma,
           place == 0  ? "exact"
           : place > 0 ? "right"
           : alike     ? "alike"
                       : "WRONG",
           compared->listed,
           causes_text(named, room, blame->sets[0].suspects, blame->sets[0].count),
           blame->sets[0].probability, wrong ? " FALSE" : "",
           blame->is_cut ? " cut" : "");
}

static void run_case(struct tally *tally, struct room *room, uint64_t seed, int number)
{
    double theirs[PP_COMPARE_POINTS_MOST], errors[PP_COMPARE_POINTS_MOST];
    double truth[PP_COMPARE_POINTS_MOST], noise[PP_COMPARE_POINTS_MOST];
    double sigma = 0.005 * pow(6.0, even(seed, number, 4, 0)), factor = 1.0;
    int causes[PP_BLAME_MOST];
    int count = draw_causes(causes, room, seed, number, sigma);
    struct pp_as_if as_if = pp_as_if_nothing();
    const struct pp_suspect *const *list;
    struct pp_error err;
    pp_compare_suspects(room->compare, &list);
    for (int i = 0; i < count; i++) {
        double u = 2.0 * even(seed, number, 5, 0) - 1.0;
        if (list[causes[i]]->is_factor)
            factor = exp(u < 0.0 ? -0.05 + 0.4 * u : 0.05 + 0.4 * u);
        else
            must(pp_as_if_add(&as_if, list[causes[i]]->word, &err), &err);
    }
    const struct pp_as_if_tracing tracing = {
        .error = 0.004, .seed = 1000 + seed * 1000 + (uint64_t)number, .threads = 1};
    const struct pp_as_if_tracing ours = {.error = 0.008, .seed = 1, .threads = 1};
    must(pp_as_if_values(theirs, errors, &room->study, &as_if, &tracing, &err), &err);
    must(pp_as_if_values(truth, errors, &room->study, &as_if, &ours, &err), &err);
    draw_noise(noise, room, seed, number);
    for (int i = 0; i < room->study.receiver_count; i++) {
        truth[i] *= factor;
        theirs[i] *= factor * exp(sigma * noise[i]);
    }
    struct pp_compared compared;
    must(pp_compare_explain(&compared, room->compare, theirs, &err), &err);
    judge(tally, room, &compared, causes, count, truth, sigma);
    pp_compare_clear(&compared);
    fflush(stdout);
}

int main(int argc, char **argv)
{
    static struct room rooms[ROOMS_MOST];
    struct tally tally = {0};
    int room_count = argc - 3;
    if (room_count < 1 || room_count > ROOMS_MOST) {
        fputs("Usage: compare_causes SEED CASES ROOM.xml...\n", stderr);
        return 2;
    }
    uint64_t seed = strtoull(argv[1], NULL, 10);
    int cases = atoi(argv[2]);
    double began_s = processor_s();
    for (int i = 0; i < room_count; i++)
        read_room(&rooms[i], argv[3 + i]);
    for (int number = 0; number < cases; number++)
        run_case(&tally, &rooms[number % room_count], seed, number);
    printf(
        "%d cases: %d right (%d exact, %.1f sets listed a case), %d right or not to be "
        "told; with one cause %d of %d, two %d of %d, three %d of %d\n",
        tally.cases, tally.right, tally.exact, (double)tally.listed / tally.cases,
        tally.alike, tally.right_of[1], tally.of[1], tally.right_of[2], tally.of[2],
        tally.right_of[3], tally.of[3]);
    printf(
        "%d suspects called sure, %d of them falsely (%.1f %%), in %d cases; %.0f s\n",
        tally.accused, tally.falsely, 100.0 * tally.falsely / tally.accused,
        tally.wrong_cases, processor_s() - began_s);
    for (int i = 0; i < room_count; i++) {
        pp_compare_destroy(rooms[i].compare);
        pp_study_room_clear(&rooms[i].study);
        pp_building_destroy(rooms[i].building);
    }
    return 0;
}
