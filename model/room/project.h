/* project.h - client, author and other facts of a room file, for the title block of
 * reports. */
#ifndef PP_MODEL_ROOM_PROJECT_H
#define PP_MODEL_ROOM_PROJECT_H

/* Members are NULL if not given. */
struct pp_project {
    const char *name, *client, *number, *author, *checked, *date, *revision;
};

enum { PP_PROJECT_FACTS = 7 };

/* name: attribute of <project> and option of report; label: its name in a report. */
struct pp_project_fact {
    const char *name, *label;
};
extern const struct pp_project_fact pp_project_facts[PP_PROJECT_FACTS];

/* Value of the fact with that index in pp_project_facts; NULL: not given. */
const char *pp_project_at(const struct pp_project *project, int index);

/* Pointer to the member of *project that holds the fact with that index. */
const char **pp_project_place(struct pp_project *project, int index);

#endif
