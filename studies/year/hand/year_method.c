/* year_method.c - the list of the hand methods for the year. */
#include "studies/year/hand/year_method.h"

#include <stdio.h>
#include <string.h>

#include "model/base/text.h"

/* clang-format off */
const struct pp_year_method *const pp_year_methods[] = {
    &pp_year_method_df_diffuse,
    &pp_year_method_df_global,
    &pp_year_method_df_orientation,
    &pp_year_method_df_rule,
    &pp_year_method_doe2,
    &pp_year_method_adeline,
    &pp_year_method_adeline_mean,
    &pp_year_method_four_skies,
    &pp_year_method_classes,
    &pp_year_method_classes_scaled,
    NULL,
};
/* clang-format on */

/* The lumen method of df by one of its names. */
static enum pp_status refuse_lumen(const char *name, struct pp_error *err)
{
    return pp_fail(err, PP_BAD_INPUT,
                   "%s is not available for the year: public sources do not give the "
                   "coefficients of the lumen method for every hour; expected other "
                   "methods, or --df %s for its daylight factors",
                   name, name);
}

enum pp_status pp_year_method_choose(struct pp_year_methods_choice *choice,
                                     const char *text, struct pp_error *err)
{
    const char *names[PP_YEAR_METHODS_MOST + 1] = {"all"};
    bool chosen[PP_YEAR_METHODS_MOST] = {false};
    int count = 0;
    for (; pp_year_methods[count]; count++)
        names[count + 1] = pp_year_methods[count]->name;
    for (const char *word = text;; word++) {
        size_t length = strcspn(word, ",");
        int found = 0;
        while (found <= count
               && (strncmp(names[found], word, length) != 0 || names[found][length]))
            found++;
        if (found > count || length == 0) {
            char typed[64];
            snprintf(typed, sizeof typed, "%.*s", (int)length, word);
            if (strcmp(typed, "lumen") == 0 || strcmp(typed, "lumen-one") == 0)
                return refuse_lumen(typed, err);
            return pp_text_unknown(err, typed, names, count + 1, NULL,
                                   "there is no method for the year \"%s\"", typed);
        }
        for (int i = 0; i < count; i++)
            chosen[i] |= found == 0 || found == i + 1;
        word += length;
        if (!*word)
            break;
    }
    choice->count = 0;
    for (int i = 0; i < count; i++)
        if (chosen[i])
            choice->list[choice->count++] = pp_year_methods[i];
    return PP_OK;
}
