/* Runs a program and keeps what it prints. Include after cmocka.h.
 *
 *     char output[4096];
 *     assert_int_equal(run(output, sizeof output, "/path/program", "--argument"), 0);
 */
#ifndef RL_TESTS_RUN_H
#define RL_TESTS_RUN_H

#include <stdio.h>
#include <sys/wait.h>
#include <unistd.h>

/* The exit status, or -1 if it did not exit by itself. Output beyond size - 1 bytes ends the program. */
static inline int run(char output[], size_t size, const char *program, const char *argument)
{
    int ends[2];
    assert_int_equal(pipe(ends), 0);
    fflush(NULL);
    pid_t child = fork();
    if (child == 0) {
        dup2(ends[1], STDOUT_FILENO);
        close(ends[0]);
        close(ends[1]);
        execl(program, program, argument, (char *)NULL);
        _exit(127);
    }
    close(ends[1]);
    size_t length = 0;
    ssize_t n = 0;
    while (length < size - 1 && (n = read(ends[0], output + length, size - 1 - length)) > 0)
        length += (size_t)n;
    output[length] = '\0';
    close(ends[0]);
    int status = 0;
    assert_int_equal(waitpid(child, &status, 0), child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

#endif
