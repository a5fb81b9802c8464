"""Faults planted one at a time in what all routes share, and in the routes: who notices?"""
