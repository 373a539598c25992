/* rough_finishes.c - see rough_finishes.h. */
#include "model/light/rough/rough_finishes.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"

struct pp_rough_finishes {
    struct pp_rough_finish **list; /* each has its own memory, so that it never moves */
    int count;
    atomic_int holders;
};

/* Fills the tables, or copies the tables of a material with the same optics. */
static enum pp_status make_surface(struct pp_rough_surface *surface,
                                   const struct pp_rough_finishes *list,
                                   const struct pp_rough_optics *optics,
                                   struct pp_error *err)
{
    surface->optics = *optics;
    for (int i = 0; i < list->count; i++)
        if (!list->list[i]->is_matt
            && pp_rough_surface_same(&list->list[i]->surface, surface)) {
            *surface = list->list[i]->surface;
            return PP_OK;
        }
    return pp_rough_surface_init(surface, optics, err);
}

/* Sets the channels of the colour of a matt finish; grey remains NAN. */
static void set_colour(struct pp_finish *finish, struct pp_rgb diffuse)
{
    if (diffuse.r == diffuse.g && diffuse.b == diffuse.g)
        return;
    finish->red = diffuse.r;
    finish->green = diffuse.g;
    finish->blue = diffuse.b;
}

static struct pp_rough_finish *make_finish(const struct pp_rough_finishes *list,
                                           const char *name,
                                           const struct pp_rough_optics *optics,
                                           int line, struct pp_error *err)
{
    struct pp_rough_finish *made = calloc(1, sizeof *made);
    char *copy = strdup(name);
    bool matt = optics->roughness == 0.0;
    if (made)
        made->surface.optics = *optics;
    if (!made || !copy
        || (!matt && make_surface(&made->surface, list, optics, err) != PP_OK)) {
        free(made);
        free(copy);
        return NULL;
    }
    made->is_matt = matt;
    double reflectance = pp_rgb_luminance(
        matt ? optics->diffuse : pp_rough_surface_reflectance(&made->surface));
    made->finish =
        (struct pp_finish){.name = copy,
                           .reflectance = reflectance,
                           .red = NAN,
                           .green = NAN,
                           .blue = NAN,
                           .specular = NAN,
                           .along = NAN,
                           .across = NAN,
                           .metal = "no",
                           .source = "room file",
                           .description = matt ? "matt" : "physically rough"};
    if (matt)
        set_colour(&made->finish, optics->diffuse);
    made->line = line;
    return made;
}

enum pp_status pp_rough_finishes_add(struct pp_rough_finishes **list, const char *name,
                                     const struct pp_rough_optics *optics,
                                     struct pp_rough_formulae formulae, int line,
                                     struct pp_error *err)
{
    if (!*list) {
        *list = calloc(1, sizeof **list);
        if (!*list)
            return pp_fail_memory(err);
        atomic_init(&(*list)->holders, 1);
    }
    struct pp_rough_finish *made = make_finish(*list, name, optics, line, err);
    if (!made)
        return pp_fail_memory(err);
    made->has_pattern = formulae.pattern != NULL;
    if (formulae.pattern)
        made->pattern = *formulae.pattern;
    made->has_bumps = formulae.height != NULL;
    if (formulae.height)
        made->height = *formulae.height;
    enum pp_status status =
        pp_array_append(&(*list)->list, (*list)->count, sizeof *(*list)->list, err);
    if (status == PP_OK) {
        (*list)->list[(*list)->count++] = made;
    } else {
        free((char *)made->finish.name);
        free(made);
    }
    return status;
}

int pp_rough_finishes_count(const struct pp_rough_finishes *list)
{
    return list ? list->count : 0;
}

const struct pp_rough_finish *pp_rough_finishes_at(const struct pp_rough_finishes *list,
                                                   int index)
{
    return list->list[index];
}

const struct pp_rough_finish *pp_rough_finishes_find(
    const struct pp_rough_finishes *list, const char *name)
{
    for (int i = 0; i < pp_rough_finishes_count(list); i++)
        if (strcmp(list->list[i]->finish.name, name) == 0)
            return list->list[i];
    return NULL;
}

int pp_rough_finishes_rough_count(const struct pp_rough_finishes *list)
{
    int count = 0;
    for (int i = 0; i < pp_rough_finishes_count(list); i++)
        count += !list->list[i]->is_matt;
    return count;
}

static const struct pp_rough_finish *material_of(const struct pp_rough_finishes *list,
                                                 const struct pp_finish *finish)
{
    for (int i = 0; finish && i < pp_rough_finishes_count(list); i++)
        if (&list->list[i]->finish == finish)
            return list->list[i];
    return NULL;
}

const struct pp_rough_finish *pp_rough_finishes_patterned(
    const struct pp_rough_finishes *list, const struct pp_finish *finish)
{
    const struct pp_rough_finish *material = material_of(list, finish);
    return material && material->has_pattern ? material : NULL;
}

const struct pp_rough_surface *pp_rough_finishes_surface(
    const struct pp_rough_finishes *list, const struct pp_finish *finish)
{
    const struct pp_rough_finish *material = material_of(list, finish);
    return material && !material->is_matt ? &material->surface : NULL;
}

struct pp_rough_finishes *pp_rough_finishes_hold(struct pp_rough_finishes *list)
{
    if (list)
        atomic_fetch_add(&list->holders, 1);
    return list;
}

void pp_rough_finishes_release(struct pp_rough_finishes *list)
{
    if (!list || atomic_fetch_sub(&list->holders, 1) > 1)
        return;
    for (int i = 0; i < list->count; i++) {
        free((char *)list->list[i]->finish.name);
        free(list->list[i]);
    }
    free(list->list);
    free(list);
}
