/* The program under test with a second entry: many recorded runs in one process, each in a fork.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Starting the program costs more than most runs take; a fork of one that is started already costs
 * little. Linked with the program's own main, renamed to graze_main.
 *
 *   replay --replay LIST SECONDS GIB   run the list until one run differs from what is expected
 *   replay --write LIST SECONDS GIB    write what each run gives to where it is expected
 *   replay ...                         the program itself
 *
 * A line of LIST is `KIND TAB FILE TAB ARGUMENT TAB ...`. With KIND `whole` FILE holds the exit
 * status on a line and standard output; with `rows` it holds the output without its lines of `#`,
 * and the exit status must be 0. A run that takes more than SECONDS of processor time is ended;
 * one that asks for more than GIB of memory, unless that is 0, is refused it.
 */
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

int graze_main(int argc, char **argv);

enum { MOST_FIELDS = 60 };

typedef struct bounds {
    rlim_t seconds, gib;
} bounds;

typedef struct text {
    size_t length;
    char *at;
} text;

static void die(const char *what) {
    perror(what);
    exit(2);
}

static text read_all(int file) {
    struct stat about;
    if (fstat(file, &about) != 0)
        die("fstat");
    text out = {(size_t)about.st_size, malloc((size_t)about.st_size + 1)};
    if (!out.at || pread(file, out.at, out.length, 0) != (ssize_t)out.length)
        die("read");
    return out;
}

/* What one run prints and how it ends: its exit status, or 256 and more for a signal. */
static int run(text *out, int argc, char **argv, bounds most) {
    int file = open("/dev/shm", O_TMPFILE | O_RDWR, 0600);
    if (file < 0)
        die("/dev/shm");
    pid_t child = fork();
    if (child < 0)
        die("fork");
    if (child == 0) {
        struct rlimit cpu = {most.seconds, most.seconds + 1};
        struct rlimit space = {most.gib << 30, most.gib << 30};
        int nowhere = open("/dev/null", O_RDWR);
        dup2(nowhere, 0);
        dup2(file, 1);
        dup2(nowhere, 2);
        if (setrlimit(RLIMIT_CPU, &cpu) != 0 || (most.gib && setrlimit(RLIMIT_AS, &space) != 0))
            _exit(99);
        exit(graze_main(argc, argv));
    }
    int status;
    if (waitpid(child, &status, 0) != child)
        die("waitpid");
    *out = read_all(file);
    close(file);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 256 + WTERMSIG(status);
}

static void drop_comments(text *t) {
    size_t kept = 0;
    for (size_t k = 0; k < t->length;) {
        const char *end = memchr(t->at + k, '\n', t->length - k);
        size_t length = end ? (size_t)(end - t->at) + 1 - k : t->length - k;
        if (t->at[k] != '#') {
            memmove(t->at + kept, t->at + k, length);
            kept += length;
        }
        k += length;
    }
    t->length = kept;
}

static void write_expected(const char *path, int status, const text *got) {
    FILE *file = fopen(path, "w");
    if (!file || fprintf(file, "%d\n", status) < 0 ||
        fwrite(got->at, 1, got->length, file) != got->length || fclose(file) != 0)
        die(path);
}

/* 'S' if a run ends in another way than expected, 'O' if it prints something else, else 0. */
static int differs(const char *path, int rows_only, int status, text *got) {
    int file = open(path, O_RDONLY), want = 0;
    if (file < 0)
        die(path);
    text expected = read_all(file);
    close(file);
    size_t head = 0;
    if (rows_only) {
        drop_comments(got);
    } else {
        expected.at[expected.length] = '\0';
        want = atoi(expected.at);
        head = (size_t)(strchr(expected.at, '\n') - expected.at) + 1;
    }
    int same = got->length == expected.length - head &&
               memcmp(got->at, expected.at + head, got->length) == 0;
    free(expected.at);
    return status != want ? 'S' : same ? 0 : 'O';
}

/* One line of the list: 0, or the kind of difference. */
static int replay_line(char *line, int number, int writes, bounds most) {
    char *field[MOST_FIELDS + 1];
    int count = 0;
    for (char *at = strtok(line, "\t"); at && count < MOST_FIELDS; at = strtok(NULL, "\t"))
        field[count++] = at;
    field[count] = NULL;
    if (count < 3) {
        fprintf(stderr, "line %d is too short\n", number);
        exit(2);
    }
    const char *path = field[1];
    field[1] = "graze";
    text got;
    int kind = 0, status = run(&got, count - 1, field + 1, most);
    if (writes)
        write_expected(path, status, &got);
    else
        kind = differs(path, strcmp(field[0], "rows") == 0, status, &got);
    free(got.at);
    if (kind)
        printf("%c %d %d\n", kind, number, status);
    return kind;
}

/* The list is read before the first fork: parent and children share the places in open files. */
static int replay(const char *list, int writes, bounds most) {
    int file = open(list, O_RDONLY), kind = 0, number = 0;
    if (file < 0)
        die(list);
    text lines = read_all(file);
    close(file);
    lines.at[lines.length] = '\0';
    for (char *line = lines.at; *line && !kind;) {
        char *end = strchr(line, '\n');
        if (end)
            *end = '\0';
        kind = replay_line(line, number++, writes, most);
        line = end ? end + 1 : "";
    }
    free(lines.at);
    return kind != 0;
}

int main(int argc, char **argv) {
    if (argc == 5 && strncmp(argv[1], "--", 2) == 0) {
        bounds most = {(rlim_t)atol(argv[3]), (rlim_t)atol(argv[4])};
        if (strcmp(argv[1], "--replay") == 0)
            return replay(argv[2], 0, most);
        if (strcmp(argv[1], "--write") == 0)
            return replay(argv[2], 1, most);
    }
    return graze_main(argc, argv);
}
