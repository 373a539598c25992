/* rad_names.c - a hash table with open addressing and linear probing, at most half
 * full. */
#include "formats/radiance/rad_names.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

struct pp_rad_name {
    char *text; /* NULL: free */
    size_t length;
    struct pp_rad_meaning meaning;
};

/* FNV-1a hash of a name. */
static size_t hash_of(const char *text, size_t length)
{
    uint64_t hash = 0xcbf29ce484222325u;
    for (size_t i = 0; i < length; i++)
        hash = (hash ^ (unsigned char)text[i]) * 0x100000001b3u;
    return (size_t)(hash ^ hash >> 32);
}

/* The slot that holds the name, or the free slot for it. */
static struct pp_rad_name *rad_name_slot(const struct pp_rad_names *names,
                                         const char *text, size_t length)
{
    size_t at = hash_of(text, length) & (names->room - 1);
    while (names->list[at].text
           && (names->list[at].length != length
               || memcmp(names->list[at].text, text, length) != 0))
        at = (at + 1) & (names->room - 1);
    return &names->list[at];
}

static bool grow_rad_names(struct pp_rad_names *names)
{
    if (2 * (names->count + 1) <= names->room)
        return true;
    struct pp_rad_names larger = {.room = names->room ? 2 * names->room : 64};
    larger.list = calloc(larger.room, sizeof *larger.list);
    if (!larger.list)
        return false;
    larger.count = names->count;
    for (size_t i = 0; i < names->room; i++)
        if (names->list[i].text)
            *rad_name_slot(&larger, names->list[i].text, names->list[i].length) =
                names->list[i];
    free(names->list);
    *names = larger;
    return true;
}

enum pp_status pp_rad_names_define(struct pp_rad_names *names, const char *text,
                                   size_t length, struct pp_rad_meaning meaning,
                                   struct pp_error *err)
{
    if (!grow_rad_names(names))
        return pp_fail_memory(err);
    struct pp_rad_name *name = rad_name_slot(names, text, length);
    if (!name->text) {
        char *copy = malloc(length + 1);
        if (!copy)
            return pp_fail_memory(err);
        memcpy(copy, text, length);
        copy[length] = '\0';
        name->text = copy;
        name->length = length;
        names->count++;
    }
    name->meaning = meaning;
    return PP_OK;
}

bool pp_rad_names_find(const struct pp_rad_names *names, const char *text,
                       size_t length, struct pp_rad_meaning *meaning)
{
    if (length == 4 && memcmp(text, "void", 4) == 0) {
        *meaning = (struct pp_rad_meaning){PP_RAD_VOID, -1, -1};
        return true;
    }
    const struct pp_rad_name *name =
        names->room ? rad_name_slot(names, text, length) : NULL;
    if (!name || !name->text)
        return false;
    *meaning = name->meaning;
    return true;
}

void pp_rad_names_clear(struct pp_rad_names *names)
{
    for (size_t i = 0; i < names->room; i++)
        free(names->list[i].text);
    free(names->list);
    *names = (struct pp_rad_names){0};
}
