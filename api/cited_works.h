/* cited_works.h - the publications in docs/SOURCES.md, which methods and formulae cite
 * by key. */
#ifndef PP_API_CITED_WORKS_H
#define PP_API_CITED_WORKS_H

/* Finds a publication by the key at the start of `place`, which may continue after a
 * comma ("GEEBELEN, eq. 15"). Returns NULL if there is none. *key (may be NULL) is set
 * to the key. */
const char *pp_cited_works_find(const char *place, const char **key);

#endif
