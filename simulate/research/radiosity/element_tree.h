/* element_tree.h - the elements of the room's sides, as trees: the roots are the pieces
 * of a side, and each level consists of the parts of the level above. The radiosity of
 * an element is uniform; a divided element has the mean radiosity of its parts.
 *
 * Sides outdoors have no elements, nor have sides that neither emit, reflect nor
 * transmit diffuse light.
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
    int side;                /* index of the side: twice the facet's index, plus 1 for
                              * the back */
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
    struct pp_element *list;        /* roots first, in the order of the sides */
    int count, room;
    struct pp_vec3 *corners;
    int corner_count, corner_room;
    int (*roots)[2]; /* for each side: the first root, and the number of roots */
};

/* Makes elements that are at most size_m long, and at most PP_ELEMENT_LONG times as
 * long as wide. facets must outlive *tree. */
enum pp_status pp_element_tree_create(struct pp_element_tree **tree,
                                      const struct pp_facets *facets, double size_m,
                                      struct pp_error *err);
void pp_element_tree_destroy(struct pp_element_tree *tree); /* NULL is allowed */

/* Divides an undivided element: into halves if it is long, otherwise into quarters. The
 * parts initially have the radiosity of the whole. */
enum pp_status pp_element_tree_divide(struct pp_element_tree *tree, int element,
                                      struct pp_error *err);

/* The undivided element at a point of a side; -1: the side has none. */
int pp_element_tree_at(const struct pp_element_tree *tree, int side,
                       struct pp_vec3 point);

/* Sets the radiosities of divided elements from their parts, and the spreads of all
 * elements. */
void pp_element_tree_average(struct pp_element_tree *tree);

/* Normal of the side, pointing to where its light goes. */
struct pp_vec3 pp_element_tree_normal(const struct pp_element_tree *tree, int side);

/* The parts of a convex polygon after a division. */
struct pp_element_parts {
    int count, counts[PP_ELEMENT_PARTS]; /* number of parts; number of corners of each
                                          * part */
    struct pp_vec3 corners[PP_ELEMENT_PARTS][PP_FORM_FACTOR_MOST];
};

/* Divides a convex polygon of a facet, with up to PP_FORM_FACTOR_MOST / 2 corners,
 * through the middle of its extent along the facet's axes: into halves if it is long,
 * otherwise into quarters. */
void pp_element_tree_cut(struct pp_element_parts *parts, const struct pp_facet *facet,
                         const struct pp_vec3 *corners, int count);

/* Centroid of a convex polygon; *area_m2 may be NULL. */
struct pp_vec3 pp_element_tree_middle(const struct pp_vec3 *corners, int count,
                                      double *area_m2);

#endif
