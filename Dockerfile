# The two commands of README.md on a bare Debian 12: docker build -t burnish .
FROM debian:bookworm
WORKDIR /burnish
COPY . .
RUN ./demo
RUN ./test
