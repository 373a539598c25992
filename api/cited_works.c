/* cited_works.c - list of publications; the build generates the list from
 * docs/SOURCES.md. */
#include "api/cited_works.h"

#include <stddef.h>
#include <string.h>

static const struct cited_work {
    const char *key, *work;
} works[] = {
#include "api/cited_works.inc"
};

const char *pp_cited_works_find(const char *place, const char **key)
{
    size_t length = strcspn(place, ",");
    for (size_t i = 0; i < sizeof works / sizeof works[0]; i++)
        if (strlen(works[i].key) == length
            && strncmp(works[i].key, place, length) == 0) {
            if (key)
                *key = works[i].key;
            return works[i].work;
        }
    return NULL;
}
