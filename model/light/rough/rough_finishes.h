/* rough_finishes.h - the materials that a room file defines, as finishes of its
 * surfaces: physically rough, or matt; with a pattern or without.
 *
 * All rooms of a file and their worlds share one list, which counts its holders. No
 * material may be added once the list has a second holder.
 */
#ifndef PP_MODEL_LIGHT_ROUGH_ROUGH_FINISHES_H
#define PP_MODEL_LIGHT_ROUGH_ROUGH_FINISHES_H

#include "model/expression/surface_pattern.h"
#include "model/light/finishes.h"
#include "model/light/rough/rough_surface.h"

struct pp_rough_finish {
    struct pp_finish finish; /* its name, and its reflectance for diffuse light, where
                              * the pattern is 1 */
    bool is_matt;            /* no tables: only surface.optics.diffuse is used */
    struct pp_rough_surface surface;
    bool has_pattern;
    struct pp_surface_pattern pattern; /* factor of the optics' `diffuse` */
    bool has_bumps;                    /* only if matt; `pattern` is then given too */
    struct pp_surface_pattern height;  /* of the bumps, m */
    int line;
};

struct pp_rough_finishes;

/* A pattern, and the height of bumps; NULL: none. A material with bumps is matt and has
 * a pattern. */
struct pp_rough_formulae {
    const struct pp_surface_pattern *pattern, *height;
};

/* Adds a material; the list is made if *list is NULL. optics: with a roughness of 0,
 * the material is matt, with the reflectance `diffuse`. */
enum pp_status pp_rough_finishes_add(struct pp_rough_finishes **list, const char *name,
                                     const struct pp_rough_optics *optics,
                                     struct pp_rough_formulae formulae, int line,
                                     struct pp_error *err);

/* A NULL list has no materials. */
int pp_rough_finishes_count(const struct pp_rough_finishes *list);
const struct pp_rough_finish *pp_rough_finishes_at(const struct pp_rough_finishes *list,
                                                   int index);
const struct pp_rough_finish *pp_rough_finishes_find(
    const struct pp_rough_finishes *list, const char *name); /* NULL: none */

/* Number of materials that are not matt. */
int pp_rough_finishes_rough_count(const struct pp_rough_finishes *list);

/* The material with a pattern of which this is the finish; NULL if the finish has no
 * pattern or is not in the list. */
const struct pp_rough_finish *pp_rough_finishes_patterned(
    const struct pp_rough_finishes *list, const struct pp_finish *finish);

/* The surface of a finish; NULL if the finish is matt or not in the list. */
const struct pp_rough_surface *pp_rough_finishes_surface(
    const struct pp_rough_finishes *list, const struct pp_finish *finish);

/* Add a holder and return the list; remove a holder and free the list after the last
 * one. NULL is allowed. */
struct pp_rough_finishes *pp_rough_finishes_hold(struct pp_rough_finishes *list);
void pp_rough_finishes_release(struct pp_rough_finishes *list);

#endif
