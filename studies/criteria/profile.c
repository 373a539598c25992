/* profile.c - the list of profiles. */
#include "studies/criteria/profile.h"

#include <stddef.h>
#include <string.h>

#include "model/base/text.h"

static const struct pp_profile profiles[] = {
    {"uk-planning", "light of neighbours and of the new rooms, by BR 209",
     "vertical-sky,former-sky,obstruction,sunlight,gardens,no-sky-line,mirror-image,"
     "uk-annex",
     "GB"},
    {"en17037", "daylight provision, view out and sunlight by EN 17037",
     "en17037,view-out,sun-exposure", ""},
    {"uk-dwellings", "daylight in dwellings by the UK annex of EN 17037", "uk-annex",
     "GB"},
    {"breeam", "average, uniformity and view of the sky, by BREEAM 2014 (replaced)",
     "average,uniformity,sky-line", ""},
    {"rights-of-light", "adequately lit area for rights of light (English law)",
     "rights-of-light", "GB"},
    {"de-dwelling", "window sizes by German building codes, and EN 17037",
     "glazing-ratio,en17037", "DE"},
};

enum { PROFILES = sizeof profiles / sizeof *profiles };

const struct pp_profile *pp_profile_at(int index)
{
    return index < PROFILES ? &profiles[index] : NULL;
}

const struct pp_profile *pp_profile_find(const char *name, struct pp_error *err)
{
    const char *names[PROFILES];
    for (int i = 0; i < PROFILES; i++) {
        names[i] = profiles[i].name;
        if (strcmp(name, names[i]) == 0)
            return &profiles[i];
    }
    pp_text_unknown(err, name, names, PROFILES, NULL, "there is no profile \"%.60s\"",
                    name);
    return NULL;
}
