/* made_words.c - see made_words.h. */
#include "cli/report/made_words.h"

#include <stdio.h>
#include <string.h>

static bool is_safe(const char *word)
{
    return *word
           && word[strspn(word, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                "0123456789_+-./,:%@=")]
                  == '\0';
}

/* Behind a space; in quotes where a shell would take it otherwise. */
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

/* An option and its word, where that was given. */
static void put_option(const char *option, const char *word, FILE *out)
{
    if (!word)
        return;
    fprintf(out, " %s", option);
    put_word(word, out);
}

static void put_choice(const struct pp_assess_words *words, FILE *out)
{
    static const char *const states[] = {[PP_STATE_BOTH] = NULL,
                                         [PP_STATE_EXISTING] = "existing",
                                         [PP_STATE_PROPOSED] = "proposed"};
    put_option("--criteria", words->criteria, out);
    put_option("--for", words->profile_name, out);
    put_option("--before", words->before, out);
    if (words->mirror_image.given)
        fprintf(out, " --mirror-image %.10g,%.10g,%.10g,%.10g",
                words->mirror_image.line.from[0], words->mirror_image.line.from[1],
                words->mirror_image.line.to[0], words->mirror_image.line.to[1]);
    put_option("--place", words->place, out);
    if (words->median_lux > 0.0 && !words->weather)
        fprintf(out, " --median-diffuse %.10g", words->median_lux);
    put_option("--weather", words->weather, out);
    if (words->french_m > 0.0)
        fprintf(out, " --vsc-point-french %.10g", words->french_m);
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

char *pp_made_words(const struct pp_assess_run *run)
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
