/* The program under test with a second entry: many recorded runs, one after another in one process.
 * SPDX-License-Identifier: GPL-3.0-or-later
 *
 * Starting the program costs more than most runs take. Linked with the program's own main, renamed
 * to graze_main.
 *
 *   replay --replay LIST SECONDS   run the list until one run differs from what is expected; what
 *                                  ends the process otherwise is the fault of the run at hand
 *   replay --write LIST SECONDS    write what each run gives to where it is expected
 *   replay ...                     the program itself
 *
 * A line of LIST is `KIND TAB FILE TAB ARGUMENT TAB ...`. With KIND `whole` FILE holds the exit
 * status on a line and standard output; with `rows` it holds the output without its lines of `#`,
 * and the exit status must be 0. A run that takes more than SECONDS of processor time ends the
 * process.
 */
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

int graze_main(int argc, char **argv);

enum { MOST_FIELDS = 60 };

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

/* What one run prints, and its exit status. `paper` is an open file that stands in for standard
 * output. */
static int run(text *out, int paper, int argc, char **argv, long seconds) {
    struct itimerval most = {.it_value = {.tv_sec = seconds}};
    int console = dup(1);
    fflush(stdout);
    if (console < 0 || ftruncate(paper, 0) != 0 || lseek(paper, 0, SEEK_SET) != 0 ||
        dup2(paper, 1) < 0 || setitimer(ITIMER_PROF, &most, NULL) != 0)
        die("a run");
    int status = graze_main(argc, argv);
    fflush(stdout);
    clearerr(stdout);
    if (dup2(console, 1) < 0)
        die("a run");
    close(console);
    *out = read_all(paper);
    return status;
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
static int replay_line(char *line, int number, int writes, int paper, long seconds) {
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
    int kind = 0, status = run(&got, paper, count - 1, field + 1, seconds);
    if (writes)
        write_expected(path, status, &got);
    else
        kind = differs(path, strcmp(field[0], "rows") == 0, status, &got);
    free(got.at);
    if (kind)
        printf("%c %d %d\n", kind, number, status);
    return kind;
}

static int replay(const char *list, int writes, long seconds) {
    int file = open(list, O_RDONLY), kind = 0, number = 0;
    if (file < 0)
        die(list);
    text lines = read_all(file);
    close(file);
    int paper = open("/dev/shm", O_TMPFILE | O_RDWR, 0600);
    if (paper < 0)
        die("/dev/shm");
    lines.at[lines.length] = '\0';
    for (char *line = lines.at; *line && !kind;) {
        char *end = strchr(line, '\n');
        if (end)
            *end = '\0';
        kind = replay_line(line, number++, writes, paper, seconds);
        line = end ? end + 1 : "";
    }
    free(lines.at);
    return kind != 0;
}

int main(int argc, char **argv) {
    if (argc == 4 && strcmp(argv[1], "--replay") == 0)
        return replay(argv[2], 0, atol(argv[3]));
    if (argc == 4 && strcmp(argv[1], "--write") == 0)
        return replay(argv[2], 1, atol(argv[3]));
    return graze_main(argc, argv);
}
