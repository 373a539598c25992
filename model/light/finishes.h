/* finishes.h - the named finishes (tables/finishes.csv). */
#ifndef PP_MODEL_LIGHT_FINISHES_H
#define PP_MODEL_LIGHT_FINISHES_H

struct pp_finish {
    const char *name;
    double reflectance;      /* total of diffuse and gloss */
    double red, green, blue; /* relative channels of the colour; NAN: grey */
    double specular;         /* specular part of the reflectance; NAN: none */
    double along, across;    /* roughness along and across; across NAN: equal */
    const char *metal;       /* "yes": the gloss is coloured too */
    const char *source;      /* as explained at the head of the table */
    const char *description;
};

int pp_finishes_count(void);
const struct pp_finish *pp_finishes_at(int index); /* in table order */

/* Finish of that name; NULL if there is none. */
const struct pp_finish *pp_finishes_find(const char *name);

#endif
