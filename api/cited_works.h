/* cited_works.h - the works that methods and formulae cite by key, from
 * docs/SOURCES.md. */
#ifndef PP_API_CITED_WORKS_H
#define PP_API_CITED_WORKS_H

/* Finds a work by its key; `place` may continue after a comma ("GEEBELEN, eq. 15").
 * NULL if there is none. *key (may be NULL) is set to the key. */
const char *pp_cited_works_find(const char *place, const char **key);

#endif
