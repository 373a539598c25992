/* element_tree.h - the elements of the room's sides, as trees: the roots are the pieces
 * of a side, and each level consists of the parts of the level above. An element's
 * radiosity is uniform; that of a divided element is the mean of its parts.
 *
 * A side without emission and reflection has no elements.
 */
#ifndef PP_SIMULATE_RESEARCH_RADIOSITY_ELEMENT_TREE_H
#define PP_SIMULATE_RESEARCH_RADIOSITY_ELEMENT_TREE_H

#include "simulate/research/radiosity/facets.h"
#include "simulate/research/radiosity/form_factor.h"

enum {
    PP_ELEMENT_PARTS = 4,
    PP_ELEMENT_LONG = 4, /* elements with a larger ratio of length to width are
                          * halved across their length only */
};

struct pp_element {
    int side;                /* index of the side: twice the facet's, plus 1 for the
                              * back */
    int first_corner, count; /* corners of the convex outline */
    struct pp_vec3 middle;   /* centre of area */
    double area_m2;
    int parent;                 /* -1: none */
    int first_part, part_count; /* elements; 0: not divided */
    double radiosity;           /* over Eh */
    double sky,
        outside; /* part of the radiosity that a diffusing pane transmits from the sky,
                  * and from other sources outside */
    double
        spread; /* possible variation of the radiosity within the element; INFINITY: not
                 * known */
};

struct pp_element_tree {
    const struct pp_facets *facets; /* not owned */
    struct pp_element *list;        /* roots first, by sides */
    int count, room;
    struct pp_vec3 *corners;
    int corner_count, corner_room;
    int (*roots)[2]; /* for each side: the first root, and the number of roots */
};

/* Makes elements with a length of at most size_m and at most PP_ELEMENT_LONG times
 * their width. facets must outlive *tree. */
enum pp_status pp_element_tree_create(struct pp_element_tree **tree,
                                      const struct pp_facets *facets, double size_m,
                                      struct pp_error *err);
void pp_element_tree_destroy(struct pp_element_tree *tree); /* NULL is allowed */

/* Divides an undivided element into halves if it is long, else into quarters. The parts
 * begin with its radiosity. */
enum pp_status pp_element_tree_divide(struct pp_element_tree *tree, int element,
                                      struct pp_error *err);

/* The undivided element at a point of a side; -1: the side has none. */
int pp_element_tree_at(const struct pp_element_tree *tree, int side,
                       struct pp_vec3 point);

/* Sets the radiosities of divided elements from their parts, and the spreads of all
 * elements. */
void pp_element_tree_average(struct pp_element_tree *tree);

/* The side's normal, on the side of emission. */
struct pp_vec3 pp_element_tree_normal(const struct pp_element_tree *tree, int side);

/* The parts of a convex polygon after a division. */
struct pp_element_parts {
    int count, counts[PP_ELEMENT_PARTS]; /* number of parts, and of each part's
                                          * corners */
    struct pp_vec3 corners[PP_ELEMENT_PARTS][PP_FORM_FACTOR_MOST];
};

/* Divides a convex polygon of a facet, with up to PP_FORM_FACTOR_MOST / 2 corners,
 * through the middle of its extent along the facet's axes: into halves if it is long,
 * else into quarters. */
void pp_element_tree_cut(struct pp_element_parts *parts, const struct pp_facet *facet,
                         const struct pp_vec3 *corners, int count);

/* Centroid of a convex polygon; *area_m2 may be NULL. */
struct pp_vec3 pp_element_tree_middle(const struct pp_vec3 *corners, int count,
                                      double *area_m2);

#endif
