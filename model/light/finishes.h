/* finishes.h - the named finishes (tables/finishes.csv). */
#ifndef PP_MODEL_LIGHT_FINISHES_H
#define PP_MODEL_LIGHT_FINISHES_H

struct pp_finish {
    const char *name;
    double reflectance;      /* diffuse and gloss together */
    double red, green, blue; /* the hue, in proportion; NAN: grey */
    double specular;         /* the part of the reflectance that is gloss; NAN: none */
    double along, across;    /* its roughness; across NAN: the same */
    const char *metal;       /* "yes": the gloss has the hue too */
    const char *source;      /* as the head of the table explains it */
    const char *description;
};

int pp_finishes_count(void);
const struct pp_finish *pp_finishes_at(int index); /* in the table's order */

/* The finish of that name, or NULL. */
const struct pp_finish *pp_finishes_find(const char *name);

#endif
