/* cited_works.h - the works that methods and formulae name by key, as docs/SOURCES.md has
 * them. */
#ifndef PP_API_CITED_WORKS_H
#define PP_API_CITED_WORKS_H

/* The work of a key, or of a place in it ("GEEBELEN, eq. 15"): the key's end is at a
 * comma. NULL: there is none. *key (may be NULL) is the key as listed. */
const char *pp_cited_works_find(const char *place, const char **key);

#endif
